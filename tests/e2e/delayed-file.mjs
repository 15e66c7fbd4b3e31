/** Delays a file until `deliver` is called. @param {string} file */
export function delayFile(file) {
  let deliver = () => {};
  const held = new Promise((resolve) => (deliver = () => resolve(undefined)));
  const before = (/** @type {import("@playwright/test").BrowserContext} */ context) =>
    context.route(file, async (route) => {
      await held;
      await route.continue();
    });
  return { before, deliver: () => deliver() };
}
