import type { PageError } from "../worker/protocol.ts";

export interface CameraListener {
  /** the camera has started, or was muted or unmuted */
  changed: () => void;
  /** the camera could not start, or has ended */
  lost: (error: PageError) => void;
  /** the video shows a new frame */
  frame?: (time_ms: number) => void;
}

/** The camera in a video element. Runs between `open` and `close`, with at most one permission request at a time. */
export function cameraStream(video: HTMLVideoElement, wanted: MediaTrackConstraints, listener: CameraListener) {
  let track: MediaStreamTrack | undefined;
  let isOpen = false;
  /** A permission prompt may outlive the view of the camera; the next `open` then uses its answer. */
  let isAsking = false;

  async function open() {
    isOpen = true;
    if (isAsking || track) return;
    isAsking = true;
    try {
      const stream = await navigator.mediaDevices.getUserMedia({ video: { facingMode: "user", ...wanted } });
      if (isOpen) begin(stream);
      else stream.getVideoTracks()[0].stop();
    } catch (error) {
      if (isOpen) listener.lost({ code: codeOf(error), message: String(error), hint: "" });
    } finally {
      isAsking = false;
    }
  }

  function begin(stream: MediaStream) {
    const [begun] = stream.getVideoTracks();
    const lose = (code: string, error: unknown) => {
      if (track === begun) listener.lost({ code, message: String(error), hint: "" });
    };
    const watch = () => {
      video.requestVideoFrameCallback((_, { mediaTime }) => {
        if (track !== begun) return;
        watch();
        listener.frame?.(1000 * mediaTime);
      });
    };
    track = begun;
    track.addEventListener("ended", () => lose("camera-lost", "the camera's track ended"));
    // A muted camera delivers black frames.
    for (const change of ["mute", "unmute"]) track.addEventListener(change, listener.changed);
    video.srcObject = stream;
    // Rejects also if the camera is closed meanwhile.
    video.play().catch((error) => lose("no-camera", error));
    if (listener.frame) watch();
    listener.changed();
  }

  /** Releases the camera. */
  function close() {
    isOpen = false;
    track?.stop();
    track = undefined;
    video.srcObject = null;
  }

  /** Whether the camera is live, unmuted and decoded. */
  function hasPicture() {
    return track?.readyState === "live" && !track.muted && video.videoWidth > 0;
  }

  /** Current frame; undefined if the browser has none, as for a moment after the camera started. */
  async function grab() {
    const grabbed = track;
    if (!hasPicture()) return undefined;
    const frame = await createImageBitmap(video).catch(() => undefined);
    if (grabbed === track) return frame;
    frame?.close();
    return undefined;
  }

  return { open, close, hasPicture, grab };
}

/** Lossless copy of a frame at full size. */
export function pngOf(frame: ImageBitmap) {
  const canvas = new OffscreenCanvas(frame.width, frame.height);
  canvas.getContext("2d", { alpha: false })?.drawImage(frame, 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/** @param error of `getUserMedia`, which only secure contexts have */
function codeOf(error: unknown) {
  if (!isSecureContext) return "needs-https";
  return error instanceof DOMException && error.name === "NotAllowedError" ? "camera-refused" : "no-camera";
}
