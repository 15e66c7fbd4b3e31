/** For a page to which a file does not come until it is delivered. @param {string} file */
export function withHeld(file) {
  let deliver = () => {};
  const held = new Promise((resolve) => (deliver = () => resolve(undefined)));
  const before = (/** @type {import("@playwright/test").BrowserContext} */ context) =>
    context.route(file, async (route) => {
      await held;
      await route.continue();
    });
  return { before, deliver: () => deliver() };
}
