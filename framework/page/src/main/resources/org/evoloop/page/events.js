// What happened: the events as a list that can be filtered, and looking back through them.
import { $, clock, element, holding, renew, say } from './dom.js';
import { sentBy } from './why.js';

const MOST_SHOWN = 60;
let text = '';
let who = '';
let rows = new Map(); // those shown, by number: an event that has ended stays as it is

const groups = event => [
  ['controller', 'panel', 'owner'].includes(event.source) ? 'you' : 'self',
  ...(['failed', 'dropped', 'stale'].includes(event.outcome) ? ['failed'] : []),
];

function ending(event) {
  const words = { ignored: 'no effect', stale: 'too late', failed: 'failed', dropped: 'lost', overtaken: 'overtaken' };
  if (event.outcome !== 'handled') return [words[event.outcome] ?? event.outcome, ['failed', 'dropped'].includes(event.outcome)];
  if (event.deviceActed) return ['by itself', false];
  const sent = sentBy(event);
  return [sent.length ? `sent ${sent.join(', ')}` : 'nothing sent', false];
}

const way = (page, event) => [...new Set([page.drawn('new', event.before.new), page.drawn('new', event.after.new)])].join(' → ');

const isWanted = (page, event) => (!who || groups(event).includes(who))
  && (!text || `${event.event} ${way(page, event)} ${ending(event)[0]}`.toLowerCase().includes(text));

// The newest ones up to a bit after the one looked at.
function selected(page) {
  const found = [];
  const from = page.isLive() ? page.events.length - 1 : Math.min(page.events.length - 1, page.shown + MOST_SHOWN / 3);
  for (let index = from; index >= 0 && found.length < MOST_SHOWN; index--) {
    if (isWanted(page, page.events[index])) found.push(index);
  }
  return found;
}

function row(page, index) {
  const event = page.events[index];
  const [end, bad] = ending(event);
  const what = holding('span', 'what', element('b', event.event, 'ev'), ' ', element('span', way(page, event)));
  const button = holding('button', '', element('time', clock(event.at)), what, element('span', end, bad ? 'end bad' : 'end'));
  button.type = 'button';
  button.dataset.number = event.number;
  button.addEventListener('click', () => page.look(page.events.indexOf(event)));
  return holding('li', '', button);
}

export function showEvents(page) {
  const { events } = page;
  const live = page.isLive();
  const at = live ? events.length - 1 : page.shown;
  const shown = selected(page);
  const focused = $('log').contains(document.activeElement) ? document.activeElement.dataset.number : null;
  renew($('log'), shown.map(index => events[index].number), () => {
    rows = new Map(shown.map(index => [events[index].number, rows.get(events[index].number) ?? row(page, index)]));
    return rows.size ? rows.values() : [element('li', events.length ? 'No such event.' : 'Nothing has happened yet.', 'soft small')];
  });
  for (const button of $('log').querySelectorAll('button')) {
    button.setAttribute('aria-current', Number(button.dataset.number) === events[at]?.number);
    if (button.dataset.number === focused && document.activeElement !== button) button.focus();
  }
  const last = Math.max(0, events.length - 1);
  $('position').max = last;
  $('position').value = Math.max(0, at);
  $('position').setAttribute('aria-valuetext', events[at] ? `event ${events[at].number}, ${events[at].event}` : 'no event yet');
  $('position').disabled = events.length < 2;
  $('earlier').disabled = events.length < 2 || at === 0;
  $('later').disabled = live;
  $('older').hidden = page.allLoaded || !events.length || events[0].number === 1;
  $('live-button').setAttribute('aria-pressed', live);
}

export function prepareEvents(page) {
  const sift = () => showEvents(page);
  $('filter').addEventListener('input', () => {
    text = $('filter').value.trim().toLowerCase();
    sift();
  });
  const buttons = [...document.querySelectorAll('[data-who]')];
  for (const button of buttons) {
    button.addEventListener('click', () => {
      who = button.dataset.who;
      for (const one of buttons) one.setAttribute('aria-pressed', one === button);
      sift();
    });
  }
  const at = () => (page.isLive() ? page.events.length - 1 : page.shown);
  $('position').addEventListener('input', () => page.look(Number($('position').value)));
  $('earlier').addEventListener('click', () => page.look(at() - 1));
  $('later').addEventListener('click', () => page.look(at() + 1));
  $('live-button').addEventListener('click', () => page.look(page.events.length));
  $('older').addEventListener('click', () => {
    page.shown = at();
    page.load(page.events[0].number);
  });
  $('log').addEventListener('keydown', key => {
    const step = { ArrowDown: 'nextElementSibling', ArrowUp: 'previousElementSibling' }[key.key];
    const next = step && key.target.closest('li')?.[step]?.querySelector('button');
    if (!next) return;
    key.preventDefault();
    next.focus();
    next.click();
  });
}
