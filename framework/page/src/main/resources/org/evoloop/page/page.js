// The page of a converter: it listens to /events, asks /history for what came before, and has the other modules show it.
import { showChoices } from './choices.js';
import { $, say } from './dom.js';
import { prepareEvents, showEvents } from './events.js';
import { drawModels, prepareModels, showModels } from './models.js';
import { count, showNow } from './now.js';
import { offer, prepareRest, showDevelopers, showOthers, showPictures } from './rest.js';
import { explain } from './why.js';

const MOST_KEPT = 100_000;
const TICK = 100;

const page = {
  events: [], // by number, oldest first
  status: null,
  readings: null,
  outlook: null,
  about: null,
  states: { original: new Map(), new: new Map() },
  controls: null, // what the server offers to one who has given the token
  shown: -1, // the event that is looked at; -1 for the newest
  allLoaded: false,
  connected: false,
  heardAt: 0,

  isLive() { return this.shown < 0 || this.shown >= this.events.length; },
  looked() { return this.events[this.isLive() ? this.events.length - 1 : this.shown]; },

  // States as their author drew them, without what the machine remembers in them.
  drawn(role, name) { return this.states[role].get(name)?.drawn ?? name; },
  here() { return this.drawn('new', this.status.newState); },
  isAdded(name) { return Boolean(this.states.new.get(name)?.added); },
  isAddedDrawn(drawn) { return this.about.new.states.some(one => one.drawn === drawn && one.added); },
  memory() { return this.memoryOf(this.status.newState); },
  memoryOf(name) {
    const drawn = this.drawn('new', name);
    return name.startsWith(drawn) ? /^ \[history (.*)\]$/.exec(name.slice(drawn.length))?.[1] ?? '' : '';
  },
  name() { return this.about.name; },
  title() { return this.about.name[0].toUpperCase() + this.about.name.slice(1); },
  eventNames() { return [...this.about.new.triggers, ...this.about.original.triggers]; },

  look(index) {
    this.shown = index >= this.events.length - 1 ? -1 : Math.max(0, index);
    show();
  },
  load,
  perform,
  admitted,
};

function show() {
  if (!page.status) return;
  showNow(page);
  showChoices(page);
  showModels(page);
  showEvents(page);
  explain(page, page.looked());
  showOthers(page);
  showDevelopers(page);
}

// Events

function add(more) {
  const { events } = page;
  const known = events.length ? events[events.length - 1].number : 0;
  if (more.length && more[0].number > known) {
    events.push(...more);
  } else {
    const numbers = new Set(events.map(one => one.number));
    events.push(...more.filter(one => !numbers.has(one.number)));
    events.sort((one, other) => one.number - other.number);
  }
  if (events.length > MOST_KEPT) events.splice(0, events.length - MOST_KEPT);
}

let loading = false;

async function load(before) {
  if (loading) return;
  loading = true;
  try {
    const answer = await fetch('/history' + (before ? `?before=${before}` : ''));
    if (answer.ok) {
      const more = (await answer.json()).events;
      const looked = page.events[page.shown];
      add(more);
      if (looked) page.shown = page.events.indexOf(looked);
      if (before && more.length === 0) page.allLoaded = true;
    }
  } catch {
    // The stream says that the connection is gone.
  } finally {
    loading = false;
    show();
  }
}

// The connection

let drawnFor = null;

function connected(yes, text) {
  page.connected = yes;
  say($('connection'), text);
  $('connection').className = yes ? 'conn' : 'conn bad';
}

function listen() {
  const stream = new EventSource('/events');
  stream.onopen = () => connected(true, 'live');
  stream.onerror = () => {
    connected(false, 'not connected: what is shown may be old');
    show();
    // A server that had no seat says so once, and the browser does not ask again by itself.
    if (stream.readyState === EventSource.CLOSED) setTimeout(listen, 3000);
  };
  stream.onmessage = message => {
    const update = JSON.parse(message.data);
    page.heardAt = performance.now();
    page.status = update.status;
    page.readings = update.readings;
    page.outlook = update.outlook;
    const down = update.status.link && !update.status.link.up;
    connected(true, down ? 'no link' : 'live');
    $('connection').classList.toggle('bad', Boolean(down));
    // Other models have other states and transitions to draw, and other events to press.
    const evolution = update.status.evolution.split(', on probation')[0];
    if (drawnFor !== null && drawnFor !== evolution) {
      describe().then(() => admit(null)).catch(() => location.reload());
    }
    drawnFor = evolution;
    const known = page.events.length ? page.events[page.events.length - 1].number : 0;
    add(update.events);
    if (update.last > known + update.events.length) load();
    show();
  };
}

// Doing something

async function perform(line, place) {
  say(place, `${line} …`);
  place.classList.remove('bad', 'good');
  try {
    const answer = await fetch('/command', { method: 'POST', body: line });
    if (answer.ok) {
      const told = await answer.json();
      say(place, `${line}: ${told.error || told.output || 'done'}`);
      place.classList.add(told.error ? 'bad' : 'good');
      return !told.error;
    }
    say(place, await answer.text());
    if (answer.status === 401) admitted(null);
  } catch {
    say(place, `${line}: the program cannot be reached`);
  }
  place.classList.add('bad');
  return false;
}

function admitted(controls) {
  page.controls = controls;
  offer(page);
  show();
}

async function admit(token) {
  const answer = token
    ? await fetch('/session', { method: 'POST', body: token })
    : await fetch('/controls');
  admitted(answer.ok ? await answer.json() : null);
  if (token) say($('told'), answer.ok ? 'You may control.' : 'This is not the token.');
}

$('login').addEventListener('submit', submitted => {
  submitted.preventDefault();
  admit($('token').value.trim());
  $('token').value = '';
});

// Colours: as the system says, unless chosen

const THEMES = ['auto', 'light', 'dark'];

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  $('theme').title = `Colours: ${theme}`;
  $('theme').ariaLabel = $('theme').title;
}

$('theme').addEventListener('click', () => setTheme(THEMES[(THEMES.indexOf(document.documentElement.dataset.theme) + 1) % THEMES.length]));

async function describe() {
  const about = await (await fetch('/about')).json();
  page.about = about;
  for (const role of ['original', 'new']) page.states[role] = new Map(about[role].states.map(one => [one.name, one]));
  drawModels(page);
}

async function begin() {
  setTheme('auto');
  prepareModels(page);
  prepareEvents(page);
  prepareRest(page);
  await describe();
  document.title = `${page.title()} - Evoloop`;
  say($('name'), page.title());
  showPictures(page, page.about.pictures);
  const token = new URLSearchParams(location.hash.slice(1)).get('token');
  if (token) history.replaceState(null, '', '/');
  await admit(token);
  listen();
  setInterval(() => count(page), TICK);
}

begin().catch(() => {
  connected(false, 'not connected; trying again');
  setTimeout(() => location.reload(), 3000);
});
