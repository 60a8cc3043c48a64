// The page of a converter: it listens to /events, lights the drawings, and asks /history for what came before.
const $ = id => document.getElementById(id);
const MOST_KEPT = 100_000;
const COLUMN = 480;

const events = []; // by number, oldest first
let status = null;
let drawnFor = null;
let readings = { device: [], function: [] };
let shown = -1; // the event that is looked at; -1 for the newest
let allLoaded = false;
let loading = null;
let admitted = false; // whether the server has taken the token

function element(name, text, className) {
  const made = document.createElement(name);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

// Drawings

function draw(id, svg) {
  const place = $(id);
  if (!svg) {
    place.replaceChildren(element('p', 'This machine is too large to be drawn here; its state stands above.'));
    return;
  }
  const drawn = document.importNode(new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement, true);
  // What is wide is scrolled rather than made too small to be read.
  const width = Number(drawn.getAttribute('width'));
  if (width > COLUMN) drawn.style.minWidth = `${width * 0.75}px`;
  place.replaceChildren(drawn);
}

function light(id, current, before, taken) {
  const drawn = $(id).querySelector('svg');
  if (!drawn) return;
  const isTaken = (data, withEvent) => taken.some(one => one.source === data.source && one.target === data.target
    && (!withEvent || one.event === data.event));
  for (const state of drawn.querySelectorAll('.state')) {
    state.classList.toggle('lit', state.dataset.state === current);
    state.classList.toggle('from', taken.length > 0 && state.dataset.state === before);
  }
  for (const arrow of drawn.querySelectorAll('.arrow')) arrow.classList.toggle('taken', isTaken(arrow.dataset, false));
  for (const label of drawn.querySelectorAll('.label')) label.classList.toggle('taken', isTaken(label.dataset, true));
  const way = taken.map(one => `${one.source} to ${one.target} on ${one.event}`).join(', then ');
  drawn.setAttribute('aria-label', `Current state: ${current}.` + (way ? ` Last taken: ${way}.` : ''));
}

// Events

function add(more) {
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

async function load(before) {
  if (loading) return;
  loading = true;
  try {
    const answer = await fetch('/history' + (before ? `?before=${before}` : ''));
    if (answer.ok) {
      const more = (await answer.json()).events;
      const looked = events[shown];
      add(more);
      if (looked) shown = events.indexOf(looked);
      if (before && more.length === 0) allLoaded = true;
    }
  } catch {
    // The stream says that the connection is gone.
  } finally {
    loading = null;
    if (status) showStatus();
    show();
  }
}

const OUTCOMES = {
  handled: 'handled', ignored: 'ignored', stale: 'came too late', failed: 'FAILED', dropped: 'LOST: the queue was full',
  overtaken: 'overtaken',
};
const MEANINGS = {
  'not-acceptable': 'the new model has no transition for it here',
  'existing-function': 'the next state is one that the device has; the steps below take it there',
  'new-function': 'the next state is new: its function is the converter\'s',
  resynchronization: 'the device was found elsewhere, and both models follow',
  sending: 'a new function has the device do something',
  inquiry: 'the record is in doubt: the device is asked where it is',
  refused: 'a rule of the converter refuses it',
  impossible: 'the device cannot be taken there',
};

function duration(nanos) {
  if (nanos < 999_500) return `${(nanos / 1e3).toPrecision(3)} µs`;
  return nanos < 999_500_000 ? `${(nanos / 1e6).toPrecision(3)} ms` : `${(nanos / 1e9).toPrecision(3)} s`;
}

function list(place, pairs) {
  place.replaceChildren(...pairs.filter(([, text]) => text !== '' && text !== null && text !== undefined)
    .flatMap(([term, text, className]) => [element('dt', term), element('dd', text, className)]));
}

const isViolation = event => event.outcome === 'failed' && event.event.startsWith('violation of ');
const arrow = one => `${one.source} → ${one.target} on ${one.event}`;

function explain(event) {
  const decision = event.decision;
  const steps = decision ? decision.steps : [];
  const guards = [...new Set([...(decision?.transition?.guards ?? []), ...steps.flatMap(one => one.guards)])];
  const sent = steps.filter(one => !one.byDevice).map(one => one.sends).join(', ');
  const isDone = event.outcome === 'handled';
  $('headline').textContent = `${event.number}. ${event.event}: ${OUTCOMES[event.outcome] ?? event.outcome}`;
  list($('why'), [
    ['When', new Date(event.at).toLocaleString()],
    ['Observed', event.tookNanos >= 1e9 ? new Date(event.observedAt).toLocaleString() : ''],
    ['From', isViolation(event) ? '' : event.source + (event.deviceActed ? ', the device has already acted' : '') + (event.values ? `, ${event.values}` : '')],
    ['Original model', event.before.original === event.after.original ? `stays in ${event.after.original}` : `${event.before.original} → ${event.after.original}`],
    ['New model', event.before.new === event.after.new ? `stays in ${event.after.new}` : `${event.before.new} → ${event.after.new}`],
    ['Why', decision ? MEANINGS[decision.kind] ?? decision.kind : ''],
    ['Transition', decision?.transition ? arrow(decision.transition) : ''],
    ['Guards', guards.join(', ')],
    ['Path', steps.map(one => arrow(one) + (one.byDevice ? ' (by the device)' : '')).join(', then ')],
    [isDone ? 'Sent' : 'Planned to send', decision ? sent || 'nothing' : ''],
    ['Effects', decision ? decision.effects.join('; ') : ''],
    ['Took', duration(event.tookNanos)],
    ['Detail', event.detail, event.outcome === 'failed' ? 'bad' : ''],
  ]);
}

// All of it

function show() {
  const live = shown < 0 || shown >= events.length;
  const event = events[live ? events.length - 1 : shown];
  const last = Math.max(0, events.length - 1);
  $('position').max = last;
  $('position').value = live ? last : shown;
  $('position').setAttribute('aria-valuetext', event ? `event ${event.number}, ${event.event}` : 'no event yet');
  $('position').disabled = events.length < 2;
  $('earlier').disabled = events.length < 2 || (live ? last : shown) === 0;
  $('later').disabled = live;
  $('older').disabled = allLoaded || !events.length || events[0].number === 1;
  $('live').setAttribute('aria-pressed', live);
  if (event) explain(event);
  if (!status) return;
  const now = live ? { original: status.originalState, new: status.newState } : event.after;
  const isOfNow = event && (event.after.original === now.original && event.after.new === now.new);
  const decision = isOfNow && event.outcome === 'handled' ? event.decision : null;
  light('original', now.original, event?.before.original, decision ? decision.steps : []);
  light('new', now.new, event?.before.new, decision?.transition ? [decision.transition] : []);
  const text = live
    ? `${status.loop}: the device is in ${now.original}, the new model in ${now.new}`
    : `After event ${event.number} the device was in ${now.original}, the new model in ${now.new}`;
  // A screen reader tells what has changed, and nothing else.
  if ($('now').textContent !== text) $('now').textContent = text;
}

const plural = (count, what) => `${count} ${what}${count === 1 ? '' : 's'}`;

function showStatus() {
  const warnings = [
    status.doubt && `The device's state is in doubt: ${status.doubt}`,
    status.link && !status.link.up && `The link is down: ${status.link.text}`,
    status.lastKnownSince && status.loop === 'running' && `Last known at ${new Date(status.lastKnownSince).toLocaleString()}`,
  ].filter(Boolean);
  const text = warnings.join('. ');
  $('warning').hidden = !text;
  if ($('warning').textContent !== text) $('warning').textContent = text;
  const { queue, events: counts, conversionTime, link, faults } = status;
  const running = status.function;
  const violated = events.findLast(isViolation);
  list($('status'), [
    ['Loop', status.loop, status.loop === 'running' ? 'good' : ''],
    ['Queue', `${queue.depth} waiting, highest ${queue.highest}, room for ${queue.capacity} presses`],
    ['Lost', `${queue.dropped} dropped, ${queue.refused} refused`, queue.dropped ? 'bad' : ''],
    ['Events', `${counts.handled} handled, ${counts.ignored} ignored, ${counts.stale} stale, ${counts.failed} failed`],
    ['Drift', status.drift.text, 'bad'],
    ['Violated', violated ? `${violated.event.slice('violation of '.length)}, ${new Date(violated.at).toLocaleString()}` : '', 'bad'],
    ['Conversion', conversionTime.events ? `last ${duration(conversionTime.lastNanos)}, median ${duration(conversionTime.medianNanos)}, 99th percentile ${duration(conversionTime.percentile99Nanos)}` : 'none yet'],
    ['Function', running.state ? [running.state, running.progress, ...readings.function].filter(Boolean).join(', ') : 'none'],
    ['Timers', readings.timers.join(', ')],
    ['Link', link ? `${link.up ? 'up' : 'DOWN'}${link.text ? `, ${link.text}` : ''}` : '', link && !link.up ? 'bad' : 'good'],
    ['Device', link && !link.up ? 'unknown' : readings.device.join(', ')],
    ...faults.map(fault => ['Fault', `${fault.part}: ${plural(fault.failures, 'failure')}, the last: ${fault.lastFailure}`, 'bad']),
  ]);
  $('components').replaceChildren(...status.components.map(component => {
    const row = document.createElement('tr');
    const stuck = component.activity === 'stuck';
    row.append(element('td', component.name), element('td', component.role), element('td', component.activity, stuck ? 'bad' : ''),
      element('td', component.failures ? `${component.failures}, the last: ${component.lastFailure}` : '0', component.failures ? 'bad' : ''));
    return row;
  }));
  const names = status.components.map(component => component.name);
  if ($('component').dataset.names !== names.join()) {
    $('component').dataset.names = names.join();
    $('component').replaceChildren(...names.map(name => new Option(name)));
  }
}

function listen() {
  const stream = new EventSource('/events');
  stream.onopen = () => { $('connection').textContent = 'connected'; };
  stream.onerror = () => {
    $('connection').textContent = 'not connected: what is shown may be old';
    // A server that had no seat says so once, and the browser does not ask again by itself.
    if (stream.readyState === EventSource.CLOSED) setTimeout(listen, 3000);
  };
  stream.onmessage = message => {
    const update = JSON.parse(message.data);
    ({ status, readings } = update);
    // Other models have other states and transitions to draw, and other events to press.
    const evolution = status.evolution.split(', on probation')[0];
    if (drawnFor !== null && drawnFor !== evolution) {
      drawModels().then(() => admit(null)).catch(() => location.reload());
    }
    drawnFor = evolution;
    const known = events.length ? events[events.length - 1].number : 0;
    add(update.events);
    if (update.last > known + update.events.length) load();
    showStatus();
    showOthers();
    show();
  };
}

// Other models

let shadowShown = '';
let evolves = false;

const clock = at => new Date(at).toLocaleTimeString();

function difference({ at, event, source, then, now }) {
  const item = element('li', `${clock(at)}  ${event} (${source})`);
  const both = document.createElement('dl');
  list(both, [['Running models', then], ['Shadow', now]]);
  item.append(both);
  return item;
}

function showOthers() {
  const { evolution, shadow } = status;
  $('others').hidden = !evolution && !shadow && !evolves;
  $('evolution').textContent = evolution ? `Running: ${evolution}` : '';
  $('back').hidden = !evolves || !(evolution || shadow);
  $('promote').hidden = $('off').hidden = !shadow;
  $('rollback').hidden = !evolution;
  if (shadow !== shadowShown) showShadow(shadow);
}

async function showShadow(text) {
  shadowShown = text;
  $('shadow').textContent = text && `Shadow ${text}`;
  const answer = await fetch('/shadow');
  // Meanwhile there may be more, which is asked for by itself.
  if (!answer.ok || shadowShown !== text) return;
  const { since, originalState, newState, differences = [], faults = [] } = await answer.json();
  if (since) $('shadow').textContent += `, since ${clock(since)}. It would be in (${originalState}, ${newState}).`;
  $('faults').replaceChildren(...faults.map(({ at, why }) => element('li', `${clock(at)}  ${why}`, 'bad')));
  $('differences').replaceChildren(...differences.map(difference));
}

function offerModels(controls) {
  evolves = Boolean(controls?.evolves);
  const models = controls?.models ?? [];
  $('choose').hidden = !models.length;
  $('model').replaceChildren(...models.map(name => new Option(name.replace(/.*#/, ''), name)));
  if (status) showOthers();
}

$('choose').addEventListener('submit', submitted => {
  submitted.preventDefault();
  const probation = Number($('probation').value) ? ` --probation ${$('probation').value}` : '';
  perform(`${submitted.submitter.value} "${$('model').value}" --within 10${probation}`, 'told');
});
for (const [id, line] of [['promote', 'promote'], ['off', 'shadow off'], ['rollback', 'rollback']]) {
  $(id).addEventListener('click', () => perform(line, 'told'));
}

// Looking back

function look(index) {
  shown = index >= events.length - 1 ? -1 : Math.max(0, index);
  show();
}
const at = () => (shown < 0 ? events.length - 1 : shown);
$('position').addEventListener('input', () => look(Number($('position').value)));
$('earlier').addEventListener('click', () => look(at() - 1));
$('later').addEventListener('click', () => look(at() + 1));
$('live').addEventListener('click', () => look(events.length));
$('older').addEventListener('click', () => {
  shown = at();
  load(events[0].number);
});

// Doing something

async function perform(line, place = 'answer') {
  $(place).textContent = `${line} ...`;
  try {
    const answer = await fetch('/command', { method: 'POST', body: line });
    if (answer.ok) {
      const told = await answer.json();
      $(place).textContent = `${line}: ${told.error || told.output || 'done'}`;
      $(place).className = told.error ? 'bad' : 'good';
    } else {
      $(place).textContent = await answer.text();
      if (answer.status === 401) offer(null);
    }
  } catch {
    $(place).textContent = `${line}: the program cannot be reached`;
  }
}

function offer(controls) {
  admitted = Boolean(controls);
  $('login').hidden = Boolean(controls);
  $('buttons').hidden = !controls;
  $('exchange').hidden = !controls?.spares.length;
  const lines = ['start', 'stop', ...(controls?.commands ?? []).flatMap(command =>
    (command.choices.length ? command.choices.map(choice => `${command.name} ${choice}`) : [command.name]))];
  $('buttons').replaceChildren(...lines.map(line => {
    const button = element('button', line);
    button.type = 'button';
    button.addEventListener('click', () => perform(line));
    return button;
  }));
  $('spare').replaceChildren(...(controls?.spares ?? []).map(name => new Option(name)));
  offerModels(controls);
}

async function admit(token) {
  const answer = token
    ? await fetch('/session', { method: 'POST', body: token })
    : await fetch('/controls');
  offer(answer.ok ? await answer.json() : null);
  if (token) $('answer').textContent = answer.ok ? 'You may control.' : 'This is not the token.';
}
$('login').addEventListener('submit', submitted => {
  submitted.preventDefault();
  admit($('token').value.trim());
  $('token').value = '';
});
$('exchange').addEventListener('submit', submitted => {
  submitted.preventDefault();
  perform(`exchange "${$('component').value}" "${$('spare').value}"`);
});

// Pictures

function put(image, note, text, content) {
  note.textContent = text;
  URL.revokeObjectURL(image.src);
  image.hidden = !content?.size;
  if (image.hidden) image.removeAttribute('src');
  else image.src = URL.createObjectURL(content);
}

async function update(image, note, number, isPrivate) {
  if (isPrivate && !admitted) {
    put(image, note, 'Shown only to those who have entered the token under Controls.', null);
    return;
  }
  try {
    const answer = await fetch(`/picture?number=${number}`);
    if (answer.status === 401) offer(null);
    if (!answer.ok) return;
    put(image, note, decodeURIComponent(answer.headers.get('Picture-Note') ?? ''), await answer.blob());
    if (!image.hidden) await image.decode();
  } catch {
    // The stream says that the connection is gone; a damaged picture is followed by another.
  }
}

async function keepShowing(...picture) {
  if (!document.hidden) await update(...picture);
  setTimeout(keepShowing, 1000, ...picture);
}

function showPictures(pictures) {
  $('pictures').hidden = pictures.length === 0;
  pictures.forEach(({ name, description, private: isPrivate }, number) => {
    const figure = document.createElement('figure');
    const image = new Image();
    image.alt = description;
    image.hidden = true;
    const note = element('figcaption', '');
    figure.append(image, note);
    $('pictures').append(element('h2', name), figure);
    keepShowing(image, note, number, isPrivate);
  });
}

async function drawModels() {
  const about = await (await fetch('/about')).json();
  draw('original', about.original);
  draw('new', about.new);
  show();
  return about;
}

async function begin() {
  const { name, pictures } = await drawModels();
  document.title = `${name} - Evoloop`;
  $('name').textContent = name;
  showPictures(pictures);
  const token = new URLSearchParams(location.hash.slice(1)).get('token');
  if (token) history.replaceState(null, '', '/');
  await admit(token);
  listen();
}

begin().catch(() => {
  $('connection').textContent = 'not connected; trying again';
  setTimeout(() => location.reload(), 3000);
});
