import { Application, Logger, LogLevel, TSConfigReader, TypeDocReader } from 'typedoc';
import { expect, it } from 'vitest';

/** What typedoc asks for and what is said elsewhere. */
const SAID = [
  / \(SetSignature\)/, // at the getter
  /EventMap\.\w+\.__type\./, // at the event
  /ControlledCharacter\.body\.__type\./, // at the body
  /CharacterControlsOptions\.\w+ /, // at the field of that name
  /index\.CharacterControlsEventMap /, // at each event
];

it('should document every public name, and each of its members', async () => {
  const complaints: string[] = [];
  const app = await Application.bootstrap(
    { emit: 'none', validation: { notDocumented: true, notExported: false, invalidLink: true } },
    [new TypeDocReader(), new TSConfigReader()],
  );
  expect(app.options.getValue('validation').notDocumented).toBe(true);
  app.logger = new (class extends Logger {
    override log(message: string, level: LogLevel): void {
      if (level >= LogLevel.Warn && !SAID.some((said) => said.test(message)))
        complaints.push(message);
    }
  })();
  const project = await app.convert();
  const entries = project?.children?.map(({ name }) => name);
  expect(entries?.sort()).toEqual(['helpers', 'index', 'react', 'webgpu']);
  app.validate(project!);
  expect(complaints).toEqual([]);
});
