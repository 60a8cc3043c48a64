// Why an event ended as it did: a sentence, its steps, and the fields as the converter has them.
import { $, clock, element, holding, renew, rows, say, state, took } from './dom.js';

const MEANINGS = {
  'not-acceptable': 'no transition for it here',
  'existing-function': 'the next state is one that the device has; the steps take it there',
  'new-function': 'the next state is new: its function is the converter\'s',
  resynchronization: 'the device was found elsewhere, and the state follows',
  sending: 'a new function has the device do something',
  inquiry: 'in doubt: the device is asked where it is',
  refused: 'a rule of the converter refuses it',
  impossible: 'the device cannot be taken there',
};
const OUTCOMES = {
  handled: 'handled', ignored: 'no effect', stale: 'came too late', failed: 'failed', dropped: 'lost: the queue was full', overtaken: 'overtaken',
};
const WHO = { controller: 'you, or another controller', panel: 'a button of the device', device: 'the device', timer: 'a timer', function: 'a function', property: 'a property that is watched', owner: 'the owner' };

const isViolation = event => event.outcome === 'failed' && event.event.startsWith('violation of ');
const arrow = one => `${one.source} → ${one.target} on ${one.event}`;

export const sentBy = event => (event.decision?.steps ?? []).filter(one => !one.byDevice).map(one => one.sends);

function sentence(page, event) {
  const from = page.drawn('new', event.before.new);
  const to = page.drawn('new', event.after.new);
  const { outcome } = event;
  if (isViolation(event)) return `${event.event[0].toUpperCase()}${event.event.slice(1)}.`;
  if (outcome === 'failed') return `${event.event} failed${from === to ? `; still ${to}` : `; now ${to}`}.`;
  if (outcome === 'ignored') return `${event.event} had no effect in ${from}.`;
  if (outcome !== 'handled') return `${event.event} ${outcome === 'stale' ? 'came too late' : outcome === 'dropped' ? 'was lost: too many waited' : outcome}.`;
  if (event.decision?.kind === 'resynchronization') return `The ${page.name()} was found elsewhere: ${from} became ${to}.`;
  if (from === to) return `${event.event} was handled; it stays in ${to}.`;
  return page.isAdded(event.after.new) ? `${event.event} began ${to}, which is new.` : `${event.event} led from ${from} to ${to}.`;
}

function steps(page, event) {
  const from = page.drawn('new', event.before.new);
  const to = page.drawn('new', event.after.new);
  const kind = event.decision?.kind;
  const done = event.outcome === 'handled';
  const moved = from !== to;
  const guards = event.decision?.transition?.guards ?? [];
  const list = [[[element('b', event.event), element('small', `${WHO[event.source] ?? event.source}, ${clock(event.at)}${event.values ? `, ${event.values}` : ''}${guards.length ? `, as ${guards.join(' and ')}` : ''}`)], true]];
  const next = state(to, ...(page.isAdded(event.after.new) ? ['added'] : []));
  list.push([moved ? [state(from), ' → ', next] : ['stays in ', next], moved]);
  for (const one of event.decision?.steps ?? []) {
    const where = element('small', `${page.title()} itself: ${one.source} → ${one.target}`);
    list.push([one.byDevice ? ['by itself, before anything was sent', where] : [`${done ? 'sent' : 'planned to send'} `, element('code', one.sends), where], done]);
  }
  const isNew = kind === 'new-function';
  if (done && !sentBy(event).length && kind) list.push([[isNew ? `Nothing is sent: the function of ${to} begins.` : 'Nothing is sent.'], false]);
  for (const effect of event.decision?.effects ?? []) list.push([['ran ', element('code', effect)], done]);
  if (event.detail && !sentBy(event).includes(event.detail)) list.push([[element('span', event.detail, event.outcome === 'failed' ? 'bad' : '')], false]);
  return list;
}

export function explain(page, event) {
  if (!event) return;
  say($('headline'), sentence(page, event));
  const { decision } = event;
  renew($('steps'), [event.number, event.outcome, event.detail], () => steps(page, event).map(([content, on]) => holding('li', on ? 'act-on' : '', holding('div', '', ...content))));
  const guards = [...new Set([...(decision?.transition?.guards ?? []), ...(decision?.steps ?? []).flatMap(one => one.guards)])];
  rows($('why'), [
    ['Event', `${event.number}. ${event.event}: ${OUTCOMES[event.outcome] ?? event.outcome}`],
    ['When', new Date(event.at).toLocaleString()],
    ['Observed', event.tookNanos >= 1e9 ? new Date(event.observedAt).toLocaleString() : ''],
    ['From', isViolation(event) ? '' : event.source + (event.deviceActed ? ', the device has already acted' : '') + (event.values ? `, ${event.values}` : '')],
    ['Device', event.before.original === event.after.original ? `stays in ${event.after.original}` : `${event.before.original} → ${event.after.original}`],
    ['System', event.before.new === event.after.new ? `stays in ${event.after.new}` : `${event.before.new} → ${event.after.new}`],
    ['Decision', decision ? MEANINGS[decision.kind] ?? decision.kind : ''],
    ['Transition', decision?.transition ? arrow(decision.transition) : ''],
    ['Guards', guards.join(', ')],
    ['Path', (decision?.steps ?? []).map(one => arrow(one) + (one.byDevice ? ' (by the device)' : '')).join(', then ')],
    [event.outcome === 'handled' ? 'Sent' : 'Planned to send', decision ? sentBy(event).join(', ') || 'nothing' : ''],
    ['Effects', decision ? decision.effects.join('; ') : ''],
    ['Took', took(event.tookNanos)],
    ['Detail', event.detail],
  ]);
}
