// The parts of the panel that are made of controls, which are most of the page's code: they come
// together, after the first picture or when one of them is opened.
import './adjust_tab.ts';
import './control_field.ts';
import './view_tab.ts';
