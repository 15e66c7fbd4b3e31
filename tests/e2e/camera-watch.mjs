/** Number of camera requests, of tracks received, and of tracks still live. */
export function camera({ page }) {
  return page.evaluate(() => {
    const tracks = window.cameraTracks;
    return { asked: window.cameraAsked, tracks: tracks.length, live: tracks.filter((track) => track.readyState === "live").length };
  });
}

/** Runs in the page: makes a method of a class reject. @param {[type: string, method: string]} name */
export function rejectIn([type, method]) {
  window[type].prototype[method] = () => Promise.reject(new DOMException("failed", "AbortError"));
}

/** Runs in the page before its own scripts. Also records unhandled rejections in `rejections`. */
export function recordCamera() {
  /** @type {string[]} */
  window.rejections = [];
  addEventListener("unhandledrejection", ({ reason }) => window.rejections.push(String(reason)));
  window.cameraAsked = 0;
  /** @type {MediaStreamTrack[]} */
  window.cameraTracks = [];
  const ask = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
  navigator.mediaDevices.getUserMedia = async (wanted) => {
    if (window.isRefused) throw new DOMException("refused", "NotAllowedError");
    window.cameraAsked += 1;
    if (window.cameraWaits) await new Promise((resolve) => (window.allowCamera = resolve));
    const stream = await ask(wanted);
    window.cameraTracks.push(...stream.getTracks());
    return stream;
  };
  // As when the camera is unplugged: the track stops and fires "ended".
  window.unplugCamera = () => {
    for (const track of window.cameraTracks) {
      track.stop();
      track.dispatchEvent(new Event("ended"));
    }
  };
}
