export { crowd as default } from './group.js';
