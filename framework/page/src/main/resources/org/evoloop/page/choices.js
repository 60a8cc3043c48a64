// What can be done: the controller's events, each always in the same place.
import { $, element, holding, renew, say } from './dom.js';

let known = [];

// The command that raises an event: one of its name, or one that takes it as its word.
function commandFor(page, event) {
  const commands = page.controls?.commands ?? [];
  const own = commands.find(one => one.name === event && !one.choices.length);
  const taking = commands.find(one => one.choices.includes(event));
  return own ? own.name : taking ? `${taking.name} ${event}` : null;
}

function effect(page, next) {
  const here = page.here();
  return next.decisions.map(one => {
    const condition = one.guards.length ? ` if ${one.guards.join(' and ')}` : next.decisions.length > 1 ? ' else' : '';
    if (one.kind === 'impossible') return `not possible in ${here}${condition}`;
    const target = one.target && page.drawn('new', one.target);
    const ends = page.isAdded(page.status.newState) && target && target !== here ? `, ends ${here}` : '';
    return target ? `→ ${target}${condition}${ends}` : `stays in ${here}${condition}`;
  }).join('; ');
}

// Why it cannot be pressed now; empty if it can.
function obstacle(page, next) {
  const { status } = page;
  if (!page.connected) return 'waits: not connected';
  if (status.link && !status.link.up) return 'waits: no link';
  if (status.doubt) return 'waits: in doubt';
  if (status.loop !== 'running') return 'waits: stopped';
  if (!next.decisions.length) return next.deferred ? 'would wait here' : `no effect in ${page.here()}`;
  if (next.decisions.every(one => one.kind === 'impossible')) return `not possible in ${page.here()}`;
  return page.controls && !commandFor(page, next.event) ? `${effect(page, next)}; not from this page` : '';
}

function sent(next) {
  const some = next.decisions.map(one => one.sends.join(', ') || 'nothing');
  return some.length ? `Sends ${[...new Set(some)].join(', or ')}` : '';
}

export function showChoices(page) {
  known = page.outlook.events.filter(one => one.source === 'controller');
  renew($('acts'), known.map(one => one.event), () => known.map(({ event }) => {
    const button = holding('button', 'act', element('b', event), element('small'));
    button.type = 'button';
    button.dataset.event = event;
    button.addEventListener('click', () => press(page, button));
    return holding('li', '', button);
  }));
  for (const button of $('acts').querySelectorAll('.act')) {
    const next = known.find(one => one.event === button.dataset.event);
    const why = obstacle(page, next);
    button.setAttribute('aria-disabled', Boolean(why) || !page.controls);
    button.title = why ? '' : sent(next);
    if (button.ariaBusy !== 'true') say(button.querySelector('small'), why || effect(page, next));
  }
  $('login').hidden = Boolean(page.controls);
}

async function press(page, button) {
  const { event } = button.dataset;
  const next = known.find(one => one.event === event);
  const why = obstacle(page, next) || (page.controls ? '' : 'only with the token');
  if (why) {
    say($('told'), `${event}: ${why}. Nothing was sent.`);
    return;
  }
  button.ariaBusy = 'true';
  button.classList.remove('done', 'fail');
  say(button.querySelector('small'), 'sending …');
  const worked = await page.perform(commandFor(page, event), $('told'));
  button.ariaBusy = null;
  button.classList.add(worked ? 'done' : 'fail');
  setTimeout(() => button.classList.remove('done', 'fail'), 3000);
  showChoices(page);
}
