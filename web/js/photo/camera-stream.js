/**
 * Whether the stream is live, unmuted and decoded.
 *
 * @param {MediaStream | undefined} stream
 * @param {HTMLVideoElement} video that plays the stream
 */
export function hasPicture(stream, video) {
  const tracks = stream?.getVideoTracks() ?? [];
  const isLive = tracks.some((track) => track.readyState === "live" && !track.muted);
  return isLive && video.videoWidth > 0 && video.videoHeight > 0;
}

/** @param {MediaStream} stream */
export function stopTracks(stream) {
  for (const track of stream.getTracks()) track.stop();
}

/** Error code for a rejected `getUserMedia`. @param {unknown} error */
export function cameraErrorCode(error) {
  const isDenied = error instanceof DOMException && error.name === "NotAllowedError";
  return isDenied ? "camera-refused" : "no-camera";
}
