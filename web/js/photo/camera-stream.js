/**
 * Whether what a camera sends now is a picture of something.
 *
 * @param {MediaStream | undefined} stream
 * @param {HTMLVideoElement} video that shows it
 */
export function hasPicture(stream, video) {
  const tracks = stream?.getVideoTracks() ?? [];
  const isThere = tracks.some((track) => track.readyState === "live" && !track.muted);
  return isThere && video.videoWidth > 0 && video.videoHeight > 0;
}

/** @param {MediaStream} stream */
export function stopTracks(stream) {
  for (const track of stream.getTracks()) track.stop();
}

/** What is said of a camera that does not come. @param {unknown} error */
export function codeOf(error) {
  const refused = error instanceof DOMException && error.name === "NotAllowedError";
  return refused ? "camera-refused" : "no-camera";
}
