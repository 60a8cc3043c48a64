// The two models: lit where they are, with the step taken and what may come next; around the state as text, or as drawings.
import { $, element, holding, inWords, renew, say, state } from './dom.js';
import { Drawing, LEGIBLE } from './drawing.js';
import { targets } from './now.js';

const LEGIBLE_WIDTH = 1000; // below it, the text is easier to read than a drawing
const MOST_IN_BUTTON = 16; // letters of a state's name
const drawings = {};
let chosen = null; // what the user wants to see

const views = () => [...document.querySelectorAll('[data-view]')];

export function prepareModels(page) {
  drawings.new = new Drawing($('new'), { most: 560 });
  drawings.original = new Drawing($('original'), { most: 420 });
  for (const button of views()) {
    button.addEventListener('click', () => {
      chosen = button.dataset.view;
      choose(page);
    });
  }
}

// The model's own name; empty for one that says nothing to its owner.
function nameOf(page) {
  const name = page.about.new.name.replace(/^.*[#/]/, '');
  return /^(new|evolved|original)$/i.test(name) ? '' : name;
}

function titleOf(page, role) {
  if (role === 'original') return `The ${page.name()} itself`;
  return nameOf(page) ? `Model ${nameOf(page)}` : `The ${page.name()} with what is added`;
}

export function drawModels(page) {
  for (const role of ['new', 'original']) {
    say($(`caption-${role}`), titleOf(page, role));
    $(role).setAttribute('aria-label', `${titleOf(page, role)}: a drawing; arrow keys move it, plus and minus change its size`);
  }
  say($('model-name'), nameOf(page));
  views().find(one => one.dataset.view === 'overview').hidden = !page.about.new.overview;
  put('original', page.about.original.all);
  choose(page);
  // Small ones stand beside each other.
  const together = ['new', 'original'].reduce((sum, role) => sum + (drawings[role].width ?? Infinity), 0);
  const beside = together * 0.85 < Math.min(innerWidth, 1248) && innerWidth >= LEGIBLE_WIDTH;
  $('both').classList.toggle('two', beside);
  $('device').open = beside;
}

// What cannot be drawn is told; its signpost is always there.
function put(role, svg) {
  if (svg) {
    $(role).querySelector('p')?.remove();
    drawings[role].show(svg);
  } else {
    drawings[role].clear();
    $(role).replaceChildren(element('p', 'This machine is too large to be drawn here; around its state it is shown as text.'));
  }
}

// Whether a drawing can be read without moving it.
const fits = svg => Number(/ width="(\d+)"/.exec(svg)?.[1]) * LEGIBLE < Math.min(innerWidth, 1248);

function choose(page) {
  const { all, overview } = page.about.new;
  const view = chosen ?? (all && innerWidth >= LEGIBLE_WIDTH && fits(all) ? 'all' : 'around');
  for (const button of views()) button.setAttribute('aria-pressed', button.dataset.view === view);
  $('around').hidden = view !== 'around';
  $('views').hidden = view === 'around';
  if (view !== 'around') put('new', view === 'overview' ? overview : all);
  $('views').dataset.shows = view;
  showModels(page);
}

// The name under which a state stands in the drawing that is shown.
function boxOf(page, role, name) {
  const known = page.states[role].get(name);
  if (!known) return name;
  return role === 'new' && $('views').dataset.shows === 'overview' && known.around.length ? known.around[0] : known.drawn;
}

function stepsOf(page, role, steps) {
  return steps.map(one => ({ source: boxOf(page, role, one.source), target: boxOf(page, role, one.target), event: one.event }));
}

export function showModels(page) {
  if (!page.status || !page.about) return;
  const { status } = page;
  const event = page.looked();
  const live = page.isLive();
  const at = live || !event ? { original: status.originalState, new: status.newState } : event.after;
  const isOfNow = event && event.after.original === at.original && event.after.new === at.new;
  const decision = isOfNow && event.outcome === 'handled' ? event.decision : null;
  const doubt = live && status.doubt;
  const steps = { new: decision?.transition ? [decision.transition] : [], original: decision ? decision.steps : [] };
  const possible = live && !doubt && status.loop === 'running' ? page.prospect.events.flatMap(next => next.decisions
    .filter(one => one.target).map(one => ({ source: at.new, target: one.target, event: named(next.event, one.guards) }))) : [];
  for (const role of ['new', 'original']) light(page, role, { at: at[role], before: event?.before[role], steps: steps[role], doubt });
  drawings.new.light('may', stepsOf(page, 'new', possible));
  const held = page.memoryOf(at.new);
  drawings.new.mark('held', held ? held.split(', ') : []);
  $('key-held').hidden = !held;
  $('key-now').hidden = Boolean(doubt);
  $('key-doubt').hidden = !doubt;
  const here = page.drawn('new', at.new);
  say($('moment'), live || !event ? '' : `after event ${event.number}`);
  say(views()[0], here.length > MOST_IN_BUTTON ? 'Around' : `Around ${here}`);
  say(views().at(-1), `All ${new Set(page.about.new.states.map(one => one.drawn)).size} states`);
  say($('device-state'), doubt ? 'not certain where' : `${page.drawn('original', at.original)}, of ${page.about.original.states.length} states`);
  signpost(page, here, steps.new, live && !doubt);
}

const named = (event, guards) => (guards.length ? `${event} [${guards.join('] [')}]` : event);

function light(page, role, { at, before, steps, doubt }) {
  const drawing = drawings[role];
  const step = page.prospect.doubtful;
  const maybe = doubt ? (step && role === 'original' ? [step.source, step.target] : [at]) : [];
  drawing.mark('now', doubt ? [] : [boxOf(page, role, at)]);
  drawing.mark('doubt', maybe.map(name => boxOf(page, role, name)));
  drawing.mark('was', steps.length && before !== at ? [boxOf(page, role, before)] : []);
  drawing.light('taken', stepsOf(page, role, doubt && step && role === 'original' ? [step] : steps));
  const around = `${page.states[role].get(at)?.around.join('.') ?? ''}.`;
  for (const frame of drawing.svg?.querySelectorAll('.composite') ?? []) {
    frame.classList.toggle('in', around.startsWith(`${frame.dataset.composite}.`));
  }
  if (!drawing.svg) return;
  const way = steps.map(one => `${page.drawn(role, one.source)} to ${page.drawn(role, one.target)} on ${one.event}`).join(', then ');
  const where = doubt ? 'Not certain' : `Now ${page.drawn(role, at)}`;
  const label = `${where}.${way ? ` Last taken: ${way}.` : ''}`;
  if (drawing.svg.getAttribute('aria-label') !== label) drawing.svg.setAttribute('aria-label', label);
}

// Around the state, as text: legible at every width, and without a layout.
function signpost(page, here, taken, withWays) {
  const [last] = taken.filter(one => page.drawn('new', one.target) === here);
  const ways = withWays ? page.prospect.events.filter(one => one.decisions.some(each => each.target)) : [];
  const outs = ways.map(one => [one.event, one.source, targets(page, one)]);
  const outer = page.states.new.get(page.status.newState)?.around.join(' › ') ?? '';
  const tone = page.status.doubt && page.isLive() ? 'doubt' : 'now';
  renew($('around'), [here, last, outs, outer, tone], () => {
    const before = last ? [holding('li', '', state(page.drawn('new', last.source), 'was'), element('span', last.event, 'arr taken'))] : [];
    const after = outs.map(([event, source, target]) => {
      const arrow = element('span', inWords(event), source === 'controller' ? 'arr' : 'arr self');
      if (source !== 'controller') arrow.append(element('small', 'by itself'));
      return holding('li', '', arrow, state(target, ...(page.isAddedDrawn(target) ? ['added'] : [])));
    });
    const into = holding('ul', 'in', ...before);
    const out = holding('ul', 'out', ...(after.length ? after : [element('li', withWays ? 'Nothing leads on from here.' : '')]));
    into.ariaLabel = 'The last step';
    out.ariaLabel = 'What may come next';
    return [into, holding('div', 'mid', element('span', outer), state(here, tone)), out];
  });
}
