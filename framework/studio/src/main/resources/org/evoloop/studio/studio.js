// The studio: the text is what counts, and everything else shows it.
//
// After a change, and a moment of quiet, both models are drawn; then they are checked, the plan of what is picked is asked for, and the
// try is replayed. An answer to an older text is never shown.
import { Change } from './change.js';
import { $, $$, button, make } from './dom.js';
import { Editor } from './editor.js';
import { Files } from './files.js';
import { Findings, pills } from './findings.js';
import { Pictures } from './pictures.js';
import { Properties } from './properties.js';
import { Latest, Refused, admit, ask, onLink } from './server.js';
import { Store } from './store.js';
import { Strip } from './strip.js';
import { Try } from './try.js';

const QUIET = 300; // milliseconds
const LOOK = 4000; // milliseconds between two looks at the disk
const SIDES = ['new', 'original'];

const store = new Store();
const editor = new Editor();
const pictures = new Pictures();
const strip = new Strip(side => pictures.model(side), edit);
const findings = new Findings();
const trial = new Try(pair, keepScenario);
const properties = new Properties(pair, { go, play, keep: keepProperty });
const change = new Change({ pair, reference, machines: () => files.machines(), unsaved: () => store.unsaved, save: saveAll });
const files = new Files(store, { open, choose });
const questions = { draw: new Latest(), check: new Latest(), plan: new Latest(), device: new Latest() };

let chosen = { new: null, original: null }; // { path, name }
let found = { findings: [], unchecked: '', device: [] };
let mistakes = []; // of the last drawing
const unwritten = new Map(); // path -> why it could not be saved
let picked = null;
let around = ''; // the state whose surroundings are drawn, if only they are
let plan = [];
let turned = null;
let link = 'up';
let edits = Promise.resolve();
let waiting = 0;

function pair() {
  if (!chosen.new || !chosen.original) return null;
  return { original: chosen.original, new: chosen.new, texts: store.texts };
}

function reference(side) {
  const { path, name } = chosen[side];
  return name ? `${path}#${name}` : path;
}

// ---------- after a change ----------

function later(delay = QUIET) {
  clearTimeout(waiting);
  for (const one of Object.values(questions)) one.forget();
  document.body.dataset.busy = 'true';
  waiting = setTimeout(refresh, delay);
}

async function refresh() {
  try {
    await draw();
    await Promise.all([check(), pairedWork(), device()]);
  } catch (failure) {
    delete document.body.dataset.busy;
    if (!(failure instanceof Refused)) throw failure;
    if (failure.status !== 0 && failure.status !== 401) strip.say(failure.message, 'bad');
  }
}

async function draw() {
  const sides = pair() ?? onlyOne();
  if (!sides) {
    SIDES.forEach(side => pictures.forget(side));
    show();
    delete document.body.dataset.busy;
    return;
  }
  const answer = await questions.draw.ask('/api/draw', { pair: sides, direction: turned ?? pictures.direction, view: $('#detail').value, around });
  if (answer === null) return;
  mistakes = SIDES.flatMap(side => (answer[side]?.mistake ? [{ severity: 'error', rule: 'mistake', why: '', ...answer[side].mistake }] : []));
  pictures.show(answer);
  for (const side of SIDES) if (!chosen[side]) pictures.forget(side);
  delete document.body.dataset.busy;
  again();
  show();
}

// While there is one model only, it is drawn as both.
function onlyOne() {
  const one = chosen.new ?? chosen.original;
  return one && { original: one, new: one, texts: store.texts };
}

async function check() {
  const both = pair();
  const beside = both && propertiesBeside();
  if (beside) await store.open(beside);
  if (!both) {
    found = { ...found, findings: mistakes, unchecked: '' };
  } else {
    const answer = await questions.check.ask('/api/check', { pair: both, ...(beside && store.isUnsaved(beside) ? { properties: store.text(beside) } : {}) })
      .catch(failure => { if ([0, 401].includes(failure.status)) throw failure; return { unchecked: `The models are not checked: ${failure.message}` }; });
    if (answer === null) return;
    const list = (answer.findings ?? mistakes).map(one => (one.path === 'properties' && beside ? { ...one, path: beside } : one));
    found = { ...found, findings: list, unchecked: answer.tooLarge ?? answer.unchecked ?? '' };
  }
  properties.found(found.findings, beside, beside ? store.text(beside) : '');
  show();
}

// The file of properties that belongs to the new model.
function propertiesBeside() {
  const { path, name } = chosen.new;
  const stem = path.replace(/\.[^./]+$/, '');
  return [...store.documents.keys(), ...store.files.map(file => file.path)].find(one => one === `${stem}.properties.txt` || one === `${stem}.${name}.properties.txt`) ?? null;
}

function pairedWork() {
  properties.refresh();
  return Promise.all([trial.refresh(), planned()]);
}

async function planned() {
  plan = [];
  const asked = picked?.transition;
  if (asked && picked.side === 'new' && pair() && !mistakes.length) {
    const answer = await questions.plan.ask('/api/plan', { pair: pair(), state: asked.source, event: asked.event, guard: asked.guard ?? '' }).catch(failure => ({ words: failure.message, steps: [] }));
    if (answer === null) return;
    plan = answer.steps ?? [];
    strip.say(plan.length ? way(plan) : (answer.words ?? answer.mistake?.message ?? ''), /^(never|impossible)/.test(answer.words ?? '') ? 'warn' : '');
  }
  light();
}

function way(steps) {
  const sent = steps.filter(step => !step.byDevice).map(step => step.event);
  return `The device: ${[steps[0].source, ...steps.map(step => step.target)].join(' → ')}; ${sent.length ? `sends ${sent.join(', ')}` : 'it has done so itself, nothing is sent'}`;
}

async function device() {
  const one = store.get(editor.path);
  if (one?.kind !== 'device') return;
  const answer = await questions.device.ask('/api/device', { path: one.path, text: one.text, texts: store.texts });
  if (answer === null) return;
  found = { ...found, device: answer.problems.map(problem => ({ severity: 'error', rule: 'device', why: '', path: one.path, ...problem })) };
  show();
}

// ---------- what is picked ----------

function pick(one, { text = true } = {}) {
  picked = one;
  pictures.here = one;
  strip.show(picked);
  surround();
  const line = one?.state?.line ?? one?.transition?.line;
  const model = one && pictures.model(one.side);
  if (text && line && model) show(() => { if (editor.path !== model.path) editorTo(model.path); editor.go(line); });
  light();
  planned();
}

// The surroundings follow what is picked; an arrow of theirs leaves them as they are.
function surround() {
  const { state, transition } = picked ?? {};
  const next = state?.name ?? (transition && ![transition.source, transition.target].includes(around) ? transition.source : around);
  if (next === around) return;
  around = next;
  if ($('#detail').value === 'around') later(0);
}

// After a drawing: the same state by its name, or what the cursor's line is about now.
function again() {
  const state = picked?.state && pictures.state(picked.side, picked.state.name);
  picked = state ? { side: picked.side, state } : pictures.on(editor.path, editor.line) ?? null;
  pictures.here = picked;
  strip.update(picked);
  surround();
}

function light() {
  pictures.light({ picked, plan, now: trial.states, findings: found.findings });
}

pictures.onPick = one => pick(one);
pictures.onArrow = (side, from, to) => strip.arrow(side, from, to);
strip.onLeft = () => { strip.show(picked); $(`.view[data-side="${picked?.side ?? 'new'}"] .port`).focus(); };
editor.onTyped = (path, text) => {
  picked = null; // what the cursor's line is about, as soon as that is drawn
  store.change([[path, text]], { typed: true });
};
editor.onLine = (path, line) => {
  if (waiting && document.body.dataset.busy) return; // what is drawn has other lines
  const one = pictures.on(path, line);
  if (one) pick(one, { text: false });
};
trial.onStates = () => light();

// ---------- edits of the text ----------

// Edits follow each other, each on the text that the one before has left. If one types meanwhile, the edit begins again.
function edit(side, wanted) {
  const mine = edits.then(() => perform(side ?? 'new', wanted));
  edits = mine.catch(() => {});
  return mine.catch(failure => {
    strip.say(failure.message, 'bad');
    return false;
  });
}

async function perform(side, wanted) {
  const { path, name } = chosen[side];
  const text = store.text(path);
  const other = chosen[side === 'new' ? 'original' : 'new'];
  const both = wanted.kind === 'rename-state' && side === 'new' && other;
  const others = both && other.path !== path ? store.text(other.path) : '';
  const request = { path, text, ...(name ? { machine: name } : {}), edit: wanted, ...(both && other.path === path ? { other: other.name } : {}) };
  const { text: after, line } = await ask('POST', '/api/edit', request);
  const texts = [[path, after]];
  if (both && other.path !== path && pictures.state('original', wanted.from)) {
    texts.push([other.path, (await ask('POST', '/api/edit', { path: other.path, text: others, ...(other.name ? { machine: other.name } : {}), edit: wanted })).text]);
  }
  if (store.text(path) !== text || (texts.length > 1 && store.text(other.path) !== others)) return perform(side, wanted);
  if (wanted.kind === 'rename-state' || wanted.kind === 'add-state') {
    picked = { side, state: { name: wanted.to ?? wanted.name } };
    surround();
  }
  store.change(texts);
  if (editor.path !== path) editorTo(path);
  editor.go(line);
  later(0);
  return true;
}

function moved(step) {
  if (!step) return;
  editorTo(step.path);
  editor.go(step.line);
  later(0);
}

async function keepScenario(yaml) {
  const path = store.files.find(file => file.kind === 'device')?.path;
  if (!path) return false;
  await store.open(path);
  const text = store.text(path);
  const at = /^scenarios:[ \t]*$/m.exec(text);
  const after = at ? `${text.slice(0, at.index + at[0].length)}\n${yaml.replace(/\n$/, '')}${text.slice(at.index + at[0].length)}` : `${text.replace(/\n*$/, '\n')}scenarios:\n${yaml}`;
  store.change([[path, after]]);
  editorTo(path);
  showView('text');
  return true;
}

async function keepProperty(text) {
  const path = propertiesBeside() ?? `${chosen.new.path.replace(/\.[^./]+$/, '')}.properties.txt`;
  await store.open(path);
  store.change([[path, `${store.text(path).replace(/\n*$/, store.text(path) ? '\n' : '')}${/^[^"]+?:\s/.test(text) ? text : `${text}: ${text}`}\n`]]);
  editorTo(path);
}

// ---------- files ----------

async function choose(side, path, name) {
  await open(path);
  chosen = { ...chosen, [side]: { path, ...(name ? { name } : {}) } };
  localStorage.setItem(`evoloop-studio-pair|${store.directory}`, JSON.stringify(chosen));
  trial.run = [];
  picked = null;
  later(0);
  show();
}

async function open(path) {
  await store.open(path);
  editorTo(path);
}

function editorTo(path) {
  editor.show(path, store.text(path));
  show();
}

// Saves a file; returns why it is not saved, or nothing.
async function save(path) {
  try {
    const saved = await store.save(path);
    unwritten.delete(path);
    return saved ? '' : `${path} has changed on the disk`;
  } catch (failure) {
    unwritten.set(path, failure.message);
    return failure.message;
  }
}

// Returns why some are not saved.
async function saveAll() {
  const failures = [];
  for (const path of store.unsaved) failures.push(await save(path));
  await store.list().catch(() => {});
  show();
  return failures.filter(Boolean);
}

// ---------- what is shown ----------

function show(then) {
  const every = [...found.findings, ...found.device];
  $('#tabs').replaceChildren(...[...store.documents.keys()].map(path => make('button', {
    type: 'button', role: 'tab', ariaSelected: String(path === editor.path), tabIndex: path === editor.path ? 0 : -1, title: path, onclick: () => open(path).then(() => later(0)),
  }, path.split('/').at(-1), ...(store.isUnsaved(path) ? [make('span.dot', { title: 'not saved' }, ' ●')] : []), ...pills(every.filter(one => one.path === path)).flatMap(pill => [' ', pill]))));
  const unsaved = store.unsaved.length;
  $('#unsaved').textContent = unsaved ? `● ${unsaved} ${unsaved === 1 ? 'file' : 'files'} not saved` : 'saved';
  $('#save').disabled = !unsaved;
  $('#undo').disabled = !store.canUndo;
  $('#redo').disabled = !store.canRedo;
  const errors = found.findings.filter(one => one.severity === 'error').length;
  $('#change').replaceChildren(make('span', {}, 'Run it …', ...(errors ? [make('small', {}, `${errors} ${errors === 1 ? 'error' : 'errors'} first`)] : [])));
  $('#change').ariaDisabled = String(errors > 0 || !pair());
  editor.show(editor.path, store.text(editor.path));
  editor.mark(every.filter(one => one.path === editor.path));
  findings.show(every, { go, play }, found.unchecked);
  files.selects(chosen);
  banners();
  if (then) then();
  light();
}

function banners() {
  const list = [];
  if (link === 'ended') list.push(make('div.banner.bad', {}, make('span', {}, make('b', {}, 'The studio has ended.'), ' What you typed stays in this window. Start it again in the same folder, with the same --port.')));
  if (link === 'locked') {
    const token = make('input', { type: 'text', ariaLabel: 'Address or token that the studio printed', autocomplete: 'off' });
    const form = make('form.bar', { onsubmit: event => { event.preventDefault(); allowed(token.value); } }, token, make('button.btn.tiny', { type: 'submit' }, 'Go on'), make('span.bad', { id: 'wrong-token', role: 'status', hidden: true }, 'It is not the one.'));
    list.push(make('div.banner.bad', {}, make('span', {}, make('b', {}, 'The studio was started anew.'), ' What you typed is here. Give the address that it has printed.'), form));
  }
  if (store.unkept) list.push(make('div.banner.bad', {}, make('span', {}, 'This browser keeps nothing for this page: save before you close it.')));
  for (const [path, why] of unwritten) {
    if (store.isUnsaved(path)) list.push(make('div.banner.bad', {}, make('span', {}, make('b', {}, `${path} is not saved.`), ` ${why}`)));
  }
  for (const { path, conflict, gone, left } of store.documents.values()) {
    if (gone) {
      list.push(make('div.banner', {}, make('span', {}, make('b', {}, `${path} is no longer on the disk.`), ' Its text is here.'),
        button('Write it again', () => save(path).then(() => show()))));
    }
    if (conflict) {
      list.push(make('div.banner', {}, make('span', {}, make('b', {}, `${path} has changed on the disk.`), ' Yours is not saved.'),
        button('Compare', () => files.compare(path, conflict.text, store.text(path))), button('Keep mine', () => store.keepMine(path)), button('Take the disk’s', () => { store.takeTheirs(path); later(0); })));
    }
    for (const other of left) {
      list.push(make('div.banner', {}, make('span', {}, make('b', {}, `Another text of ${path}`), ' was typed in a window that is closed.'),
        button('Compare', () => files.compare(path, other, store.text(path))), button('Take it', () => { store.settle(path, other, true); later(0); }), button('Throw it away', () => store.settle(path, other, false))));
    }
  }
  const place = $('#banners');
  if (place.contains(document.activeElement) && place.children.length === list.length) return; // one is typing there
  place.replaceChildren(...list);
}

async function go(path, line) {
  showView('text');
  await open(path);
  editor.go(line, { focus: true });
  const one = pictures.on(path, line);
  if (one) pick(one, { text: false });
}

function play(run) {
  showTool('try');
  if (matchMedia('(max-width: 699px)').matches) showView('picture');
  return trial.play(run);
}

function showTool(name) {
  for (const tab of $$('#tools [data-tool]')) {
    const mine = tab.dataset.tool === name;
    tab.ariaSelected = String(mine);
    tab.tabIndex = mine ? 0 : -1;
    $(`#${tab.dataset.tool}`).hidden = !mine;
  }
}

function showView(name) { // on a small screen: one at a time
  $('#desk').dataset.show = name;
  for (const tab of $$('#views button')) tab.ariaSelected = String(tab.dataset.show === name);
  if ($(`#${name}.body`)) showTool(name);
}

function arrows(list) { // the tabs of a list, by arrow keys
  list.addEventListener('keydown', key => {
    const way = { ArrowRight: 1, ArrowLeft: -1 }[key.key];
    const tabs = $$('[role="tab"]', list);
    if (!way || !tabs.includes(key.target)) return;
    const next = tabs[(tabs.indexOf(key.target) + way + tabs.length) % tabs.length];
    next.click();
    $$('[role="tab"]', list)[tabs.indexOf(next)]?.focus();
  });
}

// ---------- the beginning ----------

async function allowed(written) {
  const token = /token=([^&]+)/.exec(written)?.[1] ?? written.trim();
  if (await admit(token)) connected('up');
  else $('#wrong-token').hidden = false;
}

function connected(state) {
  if (state === link) return;
  const back = state === 'up';
  link = state;
  banners();
  if (back) later(0);
  else setTimeout(retry, 1000);
}

function retry() {
  if (link === 'up') return;
  ask('GET', '/api/files').catch(() => setTimeout(retry, 1000));
}

async function look() {
  if (document.visibilityState !== 'visible' || link !== 'up') return;
  for (const path of store.documents.keys()) await store.look(path).catch(() => {});
}

const themes = ['auto', 'light', 'dark'];
function theme(name) {
  document.documentElement.dataset.theme = name;
  $('#theme').ariaLabel = $('#theme').title = `Colours: ${name}`;
  localStorage.setItem('evoloop-theme', name);
}

function keys(key) {
  const command = key.ctrlKey || key.metaKey;
  const letter = key.key.toLowerCase();
  const field = key.target.matches('input, select') && key.target.value !== key.target.dataset.sent;
  const typing = key.target.matches('input, select') || key.target.closest('dialog');
  const does = command && letter === 's' ? saveAll
    : command && letter === 'z' && !field && !key.target.closest('dialog') ? () => moved(key.shiftKey ? store.redo() : store.undo())
    : command && letter === 'y' && !field && !key.target.closest('dialog') ? () => moved(store.redo())
    : command || key.altKey || typing || key.target.matches('textarea') ? null
    : { s: () => strip.addState(side(key)), a: () => strip.arrow(side(key), picked?.side === side(key) ? picked.state?.name : undefined), delete: () => $('#delete')?.click(), f2: () => ($('#state-name') ?? $('#trigger'))?.focus() }[letter];
  if (!does) return;
  key.preventDefault();
  does();
}

const side = event => (event.target.closest?.('.view')?.dataset.side === 'original' || (picked?.side === 'original' && !event.target.closest?.('.view')) ? 'original' : 'new');

// The line where a text that is mostly prose has its first diagram; else the first line.
const firstDrawn = text => Math.max(1, text.split('\n').findIndex(line => /^\s*(```|~~~)\s*(mermaid|plantuml|puml)\b/.test(line)) + 1);

async function start() {
  onLink(connected);
  theme(localStorage.getItem('evoloop-theme') ?? 'auto');
  const token = new URLSearchParams(location.hash.slice(1)).get('token');
  if (token && (await admit(token))) history.replaceState(null, '', '/');
  await store.start();
  const folder = store.directory.split('/').at(-1) || '/';
  $('#title').textContent = folder;
  $('#folder').textContent = store.directory;
  document.title = `${folder} - Evoloop studio`;
  chosen = await files.first();
  for (const file of store.files.filter(one => one.kind === 'device').slice(0, 2)) await store.open(file.path).catch(() => {});
  const first = chosen.new ?? chosen.original;
  if (first) {
    editorTo(first.path);
    editor.go(firstDrawn(store.text(first.path)));
  } else {
    files.welcome();
  }
  later(0);
}

store.addEventListener('change', ({ detail }) => {
  if (detail === 'text') later();
  show();
});
$('#save').onclick = saveAll;
$('#undo').onclick = () => moved(store.undo());
$('#redo').onclick = () => moved(store.redo());
$('#files').onclick = () => files.dialog();
$('#change').onclick = () => { if ($('#change').ariaDisabled !== 'true') change.open(); };
$('#theme').onclick = () => theme(themes[(themes.indexOf(document.documentElement.dataset.theme) + 1) % 3]);
$('#add-state').onclick = () => strip.addState('new');
$('#add-arrow').onclick = () => strip.arrow('new', picked?.side === 'new' ? picked.state?.name : undefined);
$('#detail').onchange = () => later(0);
$('#turn').onclick = () => { turned = (turned ?? pictures.direction) === 'right' ? 'down' : 'right'; later(0); };
for (const tab of $$('#tools [data-tool]')) tab.onclick = () => showTool(tab.dataset.tool);
for (const tab of $$('#views button')) tab.onclick = () => showView(tab.dataset.show);
['tabs', 'tools', 'views'].forEach(name => arrows($(`#${name}`)));
addEventListener('keydown', keys);
addEventListener('focus', look);
setInterval(look, LOOK);
$('#text').addEventListener('beforeinput', input => { // the menu's undo
  if (!input.inputType.startsWith('history')) return;
  input.preventDefault();
  moved(input.inputType === 'historyUndo' ? store.undo() : store.redo());
});
showTool('try');
showView('text');
start();
