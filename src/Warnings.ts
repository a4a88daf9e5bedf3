/** Says each thing once, in the console, under the name of its class: a bad frame comes sixty times a second. */
export class Warnings {
  readonly #said = new Set<string>();

  /** @param name the class on whose behalf it warns */
  constructor(readonly name: string) {}

  /** @param key what counts as the same thing, if the message itself varies */
  once(message: string, key = message): void {
    if (this.#said.has(key)) return;
    this.#said.add(key);
    console.warn(`${this.name}: ${message}`);
  }
}
