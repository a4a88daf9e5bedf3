import { NOTHING } from './wrapShader.js';

/** The first line that a compiler or linker complained in. */
export function firstError(
  gl: WebGLRenderingContext,
  program: WebGLProgram,
  ...shaders: WebGLShader[]
): string {
  const logs = [
    ...shaders.map((shader) => gl.getShaderInfoLog(shader)),
    gl.getProgramInfoLog(program),
  ];
  for (const log of logs) {
    const line = log?.split('\n').find((each) => /error/i.test(each));
    if (line) return line.trim();
  }
  return logs.join(' ').trim() || 'its program does not link';
}

/**
 * Makes a program that draws nothing of one that does not link, before three uses it: the user's page shall neither see
 * an error of WebGL's nor lose a frame.
 */
export function emptyProgram(
  gl: WebGLRenderingContext,
  program: WebGLProgram,
  vertexShader: WebGLShader,
  fragmentShader: WebGLShader,
): void {
  const put = (old: WebGLShader, type: number, text: string) => {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, `#version 300 es\n${text}`);
    gl.compileShader(shader);
    gl.detachShader(program, old);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  };
  put(vertexShader, gl.VERTEX_SHADER, NOTHING.vertexShader);
  put(fragmentShader, gl.FRAGMENT_SHADER, NOTHING.fragmentShader);
  gl.linkProgram(program);
}
