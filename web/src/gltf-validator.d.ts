declare module "gltf-validator/gltf_validator.dart.js" {
  interface Report {
    issues: { numErrors: number; numWarnings: number; numInfos: number; numHints: number };
  }
  export function validateBytes(bytes: Uint8Array, options: { writeTimestamp: boolean }): Promise<Report>;
}
