// @ts-check
// A plugin of Vite: of three's decoders no more than the demo asks for, and nothing that makes code of text.

/** Decoders of Draco for files other than glTF, which three's loader names beside the one that it is given. */
const UNUSED_DRACO = /new URL\( '\.\.\/libs\/draco\/\w+\.\w+', import\.meta\.url \)\.toString\(\)/g;

/**
 * Embind, in the transcoder of KTX2 pictures, writes the functions that call into WebAssembly as text, for `Function` to
 * compile: with a content security policy without 'unsafe-eval' it cannot. These do the same without, as Emscripten
 * writes them with `-sDYNAMIC_EXECUTION=0`.
 *
 * @type {[text: string, instead: string][]}
 */
const EMBIND = [
  [
    'let[args,invokerFnBody]=createJsInvoker(argTypes,isClassMethodFunc,returns,isAsync);args.push(invokerFnBody);var invokerFn=newFunc(Function,args)(...closureArgs);',
    `function invokerFn(...given) {
      if (given.length !== argCount - 2)
        throwBindingError(humanName + ' called with ' + given.length + ' arguments, not ' + (argCount - 2));
      const destructors = needsDestructorStack ? [] : null;
      const wired = isClassMethodFunc ? [argTypes[1]['toWireType'](destructors, this)] : [];
      given.forEach((value, i) => wired.push(argTypes[i + 2]['toWireType'](destructors, value)));
      const rv = cppInvokerFunc(cppTargetFunc, ...wired);
      if (needsDestructorStack) runDestructors(destructors);
      else
        argTypes.slice(isClassMethodFunc ? 1 : 2).forEach(({ destructorFunction: destroy }, i) => {
          if (destroy !== null) destroy(wired[i]);
        });
      if (returns) return argTypes[0]['fromWireType'](rv);
    }`,
  ],
  [
    // Kinds are 0, a function or method, and 1, a constructor.
    'var invokerFunction=newFunc(Function,params)(...args);',
    `function invokerFunction(obj, func, destructorsRef, args) {
      const values = types.map((type) => {
        const value = type.readValueFromPointer(args);
        args += type['argPackAdvance'];
        return value;
      });
      const rv = kind === 1 ? new func(...values) : func.apply(obj, values);
      if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, rv);
    }`,
  ],
];

/** @param {string} code of the transcoder */
function withoutEval(code) {
  for (const [text, instead] of EMBIND) {
    if (!code.includes(text)) throw new Error('decoders: this transcoder is another one.');
    code = code.replace(text, () => instead);
  }
  return code;
}

/** @returns {import('vite').Plugin} */
export function decoders() {
  return {
    name: 'decoders',
    apply: 'build',
    transform: {
      filter: { id: /three\/examples\/jsm\/loaders\/DRACOLoader\.js$/ },
      handler: (code) => ({ code: code.replace(UNUSED_DRACO, "''"), map: null }),
    },
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle))
        if (file.type === 'asset' && /basis_transcoder.*\.js$/.test(file.fileName))
          file.source = withoutEval(String(file.source));
    },
  };
}
