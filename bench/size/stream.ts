import stream from '../../e2e/harness/stream.js';

export default stream;
