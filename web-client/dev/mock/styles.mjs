// The named styles as a server tells them: each with all that makes a look, so that one replaces
// another.
import { look } from './scene.mjs';
import { styleFiles } from './schemas.mjs';

const FIRST = 'flagship';
const rank = ({ name, title }) => `${name === FIRST ? 0 : 1}${title}`;

export const styles = styleFiles
  .map(({ name, title, description, group = 'illustration', scene }) => ({
    name,
    title,
    description,
    group,
    scene: look(scene),
  }))
  .sort((a, b) => rank(a).localeCompare(rank(b)));
