import type { FaceRequest, FileOptions, OpenedFile } from "../../wasm/rosto-vision-web.js";
import type { SourceFile } from "../work/face.ts";

/** An error, as both wasm modules throw it. */
export type PageError = { code: string; message: string; hint: string; maxMm?: number; };

/**
 * Messages between the page and its worker. Buffers and bitmaps are transferred, not copied. A request that reads
 * pictures brings their files, so that a restarted worker can decode them again.
 */

export type Stage = "decode" | "detect" | "landmarks";

export interface Opened {
  key: string;
  /** in memory, so that it stays readable */
  file: Blob;
  opened: OpenedFile;
  /** the pictures of the first face */
  bitmaps: ImageBitmap[];
}

export interface FollowedFrame {
  /** timestamp from the request */
  time_ms: number;
  /** 478 × (x/W, y/H, z/W), smoothed over time; absent without a face */
  landmarks?: Float32Array;
  /** of the frame */
  width_px: number;
  height_px: number;
  /** time to read the pixels and to find the landmarks */
  took_ms: { read: number; landmarks: number; };
  /** the frame, transferred back; the caller closes it */
  frame: ImageBitmap;
}

export type FaceTask = { type: "picture"; picture: string; } |
{ type: "texture"; face: FaceRequest; size: string; } |
{ type: "write"; face: FaceRequest; format: string; options: FileOptions; name: string; } |
{ type: "write-project"; face: FaceRequest; } |
{ type: "solid-facts"; face: FaceRequest; options: FileOptions; } |
{ type: "edited-photo"; face: FaceRequest; lead: LeadPhoto; falloffBand: number; mediaType: PhotoType; };

export type PhotoType = "image/png" | "image/jpeg";

export type LeadPhoto = { picture: string; source: SourceFile; };

export type OpenRequest = { type: "open"; id: number; key: string; file: Blob; };

export type FollowRequest = { type: "follow"; id: number; frame: ImageBitmap; time_ms: number; };

export type Request = { type: "load"; module: string; detector: string; landmarks: string; } |
  OpenRequest | (FaceTask & { id: number; files: SourceFile[]; }) | FollowRequest |
{ type: "stop-following"; };

export type Reply = { type: "alive"; lock: string; } |
{ type: "loading"; } |
{ type: "ready"; } |
{ type: "unusable"; error: PageError; } |
{ type: "progress"; id: number; stage: Stage; fraction: number; } |
{ type: "open" | FaceTask["type"]; id: number; answer: any; } |
{ type: "failed"; id: number; error: PageError; } |
{ type: "followed"; id: number; followed: FollowedFrame; } |
{ type: "not-followed"; id: number; error: PageError; } |
{ type: "trapped"; id: number; message: string; };
