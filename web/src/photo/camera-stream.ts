/**
 * Whether the stream is live, unmuted and decoded.
 *
 * @param video that plays the stream
 */
export function hasPicture(stream: MediaStream | undefined, video: HTMLVideoElement) {
  const tracks = stream?.getVideoTracks() ?? [];
  const isLive = tracks.some((track) => track.readyState === "live" && !track.muted);
  return isLive && video.videoWidth > 0 && video.videoHeight > 0;
}

export function stopTracks(stream: MediaStream) {
  for (const track of stream.getTracks()) track.stop();
}

/** Error code for a rejected `getUserMedia`. */
export function cameraErrorCode(error: unknown) {
  const isDenied = error instanceof DOMException && error.name === "NotAllowedError";
  return isDenied ? "camera-refused" : "no-camera";
}
