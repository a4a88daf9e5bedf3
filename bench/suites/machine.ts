/** What a page runs on. */
export interface Machine {
  browser: string;
  /** As WebGL names it, unmasked where the browser allows. */
  webgl: string;
  /** As WebGPU names it; 'none' without. */
  webgpu: string;
}

/** Asks the browser what it and its GPUs are called. */
export default async function describeMachine(): Promise<Machine> {
  return { browser: browserName(), webgl: webglName(), webgpu: await webgpuName() };
}

function browserName(): string {
  const { userAgent } = navigator;
  // Opera and Edge say that they are Chrome, and Chrome that it is Safari.
  for (const name of ['Edg', 'OPR', 'Firefox', 'HeadlessChrome', 'Chrome', 'Version']) {
    const version = new RegExp(`${name}/([\\d.]+)`).exec(userAgent)?.[1];
    if (version) return `${name === 'Version' ? 'Safari' : name} ${version}`;
  }
  return userAgent;
}

function webglName(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'none';
  const unmasked = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(unmasked?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER) as string;
  // A browser has few contexts, and suites want many.
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

async function webgpuName(): Promise<string> {
  // Firefox and older browsers may be without, whatever the types say.
  const gpu = (navigator as Partial<Navigator>).gpu;
  const adapter = await gpu?.requestAdapter().catch(() => null);
  if (!adapter) return 'none';
  const { vendor, architecture, device, description } = adapter.info;
  const words = [vendor, architecture, device, description].filter(Boolean);
  return words.length > 0 ? words.join(' ') : 'without a name';
}
