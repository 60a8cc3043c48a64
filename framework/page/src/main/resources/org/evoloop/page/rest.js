// What is folded: other models, and what developers ask for. Also the pictures.
import { $, clock, element, holding, plural, renew, rows, say, took } from './dom.js';

let shadowShown = '';

// Other models

function difference({ at, event, source, then, now }) {
  const both = element('dl', '', 'rows');
  rows(both, [['Running', then], ['Beside', now]]);
  return holding('li', '', `${clock(at)}  ${event} (${source})`, both);
}

export function showOthers(page) {
  const { evolution, shadow } = page.status;
  const evolves = Boolean(page.controls?.evolves);
  $('others').hidden = !evolution && !shadow && !evolves;
  say($('evolution'), evolution ? `Running: ${evolution}` : '');
  say($('others-say'), [evolution && `runs ${evolution}`, shadow].filter(Boolean).join('; '));
  $('back').hidden = !evolves || !(evolution || shadow);
  $('promote').hidden = $('off').hidden = !shadow;
  $('rollback').hidden = !evolution;
  if (shadow !== shadowShown) showShadow(shadow);
}

async function showShadow(text) {
  shadowShown = text;
  $('shadow').textContent = text && `Tried beside: ${text}`;
  const answer = await fetch('/shadow');
  // Meanwhile there may be more, which is asked for by itself.
  if (!answer.ok || shadowShown !== text) return;
  const { since, originalState, newState, differences = [], faults = [] } = await answer.json();
  if (since) $('shadow').textContent += `, since ${clock(since)}. It would be in (${originalState}, ${newState}).`;
  $('faults').replaceChildren(...faults.map(({ at, why }) => element('li', `${clock(at)}  ${why}`, 'bad')));
  $('differences').replaceChildren(...differences.map(difference));
}

function offerModels(page) {
  const models = page.controls?.models ?? [];
  $('choose').hidden = !models.length;
  $('model').replaceChildren(...models.map(name => new Option(name.replace(/.*#/, ''), name)));
  if (page.status) showOthers(page);
}

// For developers

const isViolation = event => event.outcome === 'failed' && event.event.startsWith('violation of ');

export function showDevelopers(page) {
  const { status, readings } = page;
  const { queue, events: counts, conversionTime, link, faults, components } = status;
  const running = status.function;
  const violated = page.events.findLast(isViolation);
  const failures = components.reduce((sum, one) => sum + one.failures, 0) + faults.reduce((sum, one) => sum + one.failures, 0);
  say($('developers-say'), `${plural(components.length, 'component')}, ${failures ? plural(failures, 'failure') : 'no failures'}`);
  rows($('status'), [
    ['Converter', status.loop, status.loop === 'running' ? 'good' : ''],
    ['Waiting', `${queue.depth}; at most ${queue.highest}; room for ${queue.capacity} presses`],
    ['Lost', `${queue.dropped} dropped, ${queue.refused} refused`, queue.dropped ? 'bad' : ''],
    ['Events', `${counts.handled} handled, ${counts.ignored} no effect, ${counts.stale} too late, ${counts.failed} failed`],
    ['Drift', status.drift.text, 'bad'],
    ['Violated', violated ? `${violated.event.slice('violation of '.length)}, ${new Date(violated.at).toLocaleString()}` : '', 'bad'],
    ['Conversion', conversionTime.events ? `last ${took(conversionTime.lastNanos)}, median ${took(conversionTime.medianNanos)}, 99th percentile ${took(conversionTime.percentile99Nanos)}` : 'none yet'],
    ['Function', running.state ? [running.state, running.progress, ...readings.function].filter(Boolean).join(', ') : 'none'],
    ['Link', link ? `${link.up ? 'up' : 'down'}${link.text ? `, ${link.text}` : ''}` : '', link && !link.up ? 'bad' : 'good'],
    ['Device', link && !link.up ? 'unknown' : readings.device.map(one => `${one.name} ${one.value}`).join(', ')],
    ...faults.map(fault => ['Fault', `${fault.part}: ${plural(fault.failures, 'failure')}, the last: ${fault.lastFailure}`, 'bad']),
  ]);
  const spares = page.controls?.spares ?? {};
  renew($('components'), [components.map(one => [one.name, one.role, one.activity, one.failures, one.lastFailure]), spares],
    () => components.map(one => component(page, one, spares[one.role] ?? [])));
}

function labelled(cell, label) {
  cell.dataset.th = label;
  return cell;
}

// Only a spare of its role can take a component's place.
function component(page, one, spares) {
  const failures = one.failures ? `${one.failures}, the last: ${one.lastFailure}` : '0';
  const exchange = holding('td', '', ...(spares.length ? spares.map(spare => {
    const button = element('button', spare, 'btn tiny');
    button.type = 'button';
    button.dataset.exchange = one.name;
    button.setAttribute('aria-label', `Exchange ${one.name} for ${spare}`);
    button.addEventListener('click', () => page.perform(`exchange "${one.name}" "${spare}"`, $('answer')));
    return button;
  }) : ['no spare']));
  return holding('tr', '', holding('td', '', element('b', one.name), ' ', element('span', one.role, 'soft')),
    labelled(element('td', one.activity, one.activity === 'stuck' ? 'bad' : ''), 'Does'),
    labelled(element('td', failures, one.failures ? 'bad' : ''), 'Failures'), labelled(exchange, 'Exchange for'));
}

// Commands that are no events of the models: those are buttons above, if they are a controller's.
function otherLines(page) {
  const ofModels = new Set(page.eventNames());
  return page.controls.commands.flatMap(({ name, choices }) => (choices.length
    ? choices.filter(choice => !ofModels.has(choice)).map(choice => `${name} ${choice}`)
    : ofModels.has(name) ? [] : [name]));
}

export function offer(page) {
  $('buttons').hidden = !page.controls;
  say($('allowed'), page.controls ? 'You may control' : 'You may look');
  const lines = page.controls ? ['start', 'stop', ...otherLines(page)] : [];
  renew($('buttons'), lines, () => lines.map(line => {
    const button = element('button', line, 'btn');
    button.type = 'button';
    button.addEventListener('click', () => page.perform(line, $('answer')));
    return button;
  }));
  offerModels(page);
}

export function prepareRest(page) {
  $('choose').addEventListener('submit', submitted => {
    submitted.preventDefault();
    const probation = Number($('probation').value) ? ` --probation ${$('probation').value}` : '';
    page.perform(`${submitted.submitter.value} "${$('model').value}" --within 10${probation}`, $('told-models'));
  });
  for (const [id, line] of [['promote', 'promote'], ['off', 'shadow off'], ['rollback', 'rollback']]) {
    $(id).addEventListener('click', () => page.perform(line, $('told-models')));
  }
}

// Pictures

function put(image, note, text, content) {
  say(note, text);
  URL.revokeObjectURL(image.src);
  image.hidden = !content?.size;
  if (image.hidden) image.removeAttribute('src');
  else image.src = URL.createObjectURL(content);
}

async function update(page, image, note, number, isPrivate) {
  if (isPrivate && !page.controls) {
    put(image, note, 'Shown only to those who have entered the token.', null);
    return;
  }
  try {
    const answer = await fetch(`/picture?number=${number}`);
    if (answer.status === 401) page.admitted(null);
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

export function showPictures(page, pictures) {
  $('pictures').hidden = pictures.length === 0;
  $('live').classList.toggle('no-side', pictures.length === 0);
  pictures.forEach(({ name, description, private: isPrivate }, number) => {
    const image = new Image();
    image.alt = description;
    image.hidden = true;
    const note = element('figcaption');
    $('pictures').append(element('h2', name), holding('figure', '', image, note));
    keepShowing(page, image, note, number, isPrivate);
  });
}
