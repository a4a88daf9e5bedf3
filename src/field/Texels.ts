/** What a field saw, texel by texel. */
export interface Texels {
  /** Texels per face edge. */
  readonly resolution: number;
  /** Unit vectors from the centre, 3 a texel, world axes. */
  readonly direction: Float32Array;
  /** From the centre, metres; Infinity where nothing was seen. */
  readonly distance: Float32Array;
  /** Unit vectors, 3 a texel, world axes. */
  readonly normal: Float32Array;
  /** 1 for a front, 0 for a back. */
  readonly front: Uint8Array;
}
