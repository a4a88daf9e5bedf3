/** What a collider has done so far. */
export interface CubeColliderStats {
  /** Cubemaps drawn. */
  draws: number;
  /** Cubemaps read back and decoded. */
  reads: number;
  /** Updates that drew nothing, since as many reads as there are buffers were on their way. */
  skipped: number;
  /** Asynchronous reads that had to be waited for because the reach was about to run out. */
  forced: number;
  /** Milliseconds the page has waited in read-backs, all together. */
  blocked: number;
  /** Milliseconds it waited in the last one. */
  lastBlocked: number;
  /** Milliseconds spent finding what is near and dressing it for the cubemap, all together. */
  selecting: number;
  /** Milliseconds spent handing cubemaps to the GPU, all together; of a `CubeColliderGroup` not told. */
  submitting: number;
  /** Milliseconds spent turning what was read into fields, all together. */
  decoding: number;
  /** Milliseconds from the newest field's draw to its arrival. */
  latency: number;
  /** Updates from the newest field's draw to its arrival. */
  latencyUpdates: number;
  /** Meshes in the last cubemap. */
  objects: number;
  /** Those of them that may deform unseen: skinned, morphed, with shaders that are not three's own. */
  deforming: number;
  /** Reach of the last cubemap, metres. */
  far: number;
  /** Draw calls of the last cubemap. */
  drawCalls: number;
}

/** All zero. */
export function emptyStats(): CubeColliderStats {
  return {
    draws: 0,
    reads: 0,
    skipped: 0,
    forced: 0,
    blocked: 0,
    lastBlocked: 0,
    selecting: 0,
    submitting: 0,
    decoding: 0,
    latency: 0,
    latencyUpdates: 0,
    objects: 0,
    deforming: 0,
    far: 0,
    drawCalls: 0,
  };
}
