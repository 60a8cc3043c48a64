// What the system is doing, for how long still, and what is wrong.
import { $, clock, element, holding, inWords, left, plural, renew, say, state } from './dom.js';

// A page that no longer hears from the converter must not go on counting.
const MOST_COUNTED = 1500;

const isViolation = event => event.outcome === 'failed' && event.event.startsWith('violation of ');
const joined = names => [...new Set(names)].join(' or ');

// Where an event leads from here: the names of the states.
export function targets(page, next) {
  return next ? joined(next.decisions.map(one => (one.target ? page.drawn('new', one.target) : page.here()))) : '';
}

// The timer that ends the state first, then the others.
function timers(page) {
  return page.status.timers.map(timer => {
    const next = page.outlook.events.find(one => one.event === timer.event);
    return { event: timer.event, left: timer.remainingMillis, whole: next?.delayMillis ?? 0, due: timer.due, target: targets(page, next) };
  });
}

const byItself = page => page.outlook.events.filter(one => one.source !== 'controller' && one.source !== 'timer'
  && one.decisions.some(decision => decision.target));

function doubted(page) {
  const step = page.outlook.doubtful;
  return step && step.source !== step.target ? [step.source, step.target].map(name => page.drawn('original', name)) : [page.here()];
}

function leg(label, timer) {
  const made = element('span', '', 'leg');
  const track = holding('span', 'track', document.createElement('i'));
  if (timer) made.append(element('b', '', 'left'));
  made.append(track, element('span', label));
  return made;
}

function chain(page) {
  if (page.status.doubt) {
    return doubted(page).flatMap((name, index) => [...(index ? [element('span', 'or', 'leg or')] : []), state(name, 'doubt')]);
  }
  const here = state(page.here(), page.status.loop === 'running' ? 'now' : 'was');
  if (page.status.loop !== 'running') return [here, element('span', page.status.loop, 'leg or')];
  const [timer] = timers(page);
  if (timer) return [here, leg(timer.event.startsWith('tm(') ? 'then' : timer.event, timer), state(timer.target || 'the same', 'next')];
  const [next] = byItself(page);
  return next && page.isAdded(page.status.newState) ? [here, leg(next.event, null), state(targets(page, next), 'next')] : [here];
}

function sentence(page) {
  const { status, readings } = page;
  if (status.doubt) return `Not certain: ${status.doubt}. Nothing that you press is sent before it is known.`;
  if (status.loop !== 'running') return 'Stopped: what you press is refused until it is started.';
  const told = [status.function.progress, ...readings.function].filter(Boolean).join(', ');
  const [timer] = timers(page);
  return [
    told && `${told[0].toUpperCase()}${told.slice(1)}.`,
    timer && timer.whole >= 60_000 && `Until ${clock(timer.due)}, then ${timer.target || 'it begins again'}.`,
    page.memory() && `Remembers ${page.memory()}.`,
  ].filter(Boolean).join(' ');
}

function alsoByItself(page) {
  if (page.status.doubt || page.status.loop !== 'running') return '';
  const others = timers(page).slice(1).map(one => `${inWords(one.event)} → ${one.target}`);
  const shown = timers(page).length > 0 || !page.isAdded(page.status.newState) ? 0 : 1;
  others.push(...byItself(page).slice(shown).map(one => `${one.event} → ${targets(page, one)}`));
  return others.length ? `By itself${shown || timers(page).length ? ' also' : ''}: ${others.join(', ')}` : '';
}

function alarm(page) {
  const { status, readings } = page;
  const down = status.link && !status.link.up;
  const since = status.lastKnownSince ? ` since ${clock(status.lastKnownSince)}` : '';
  if (down) return [`No link to the ${page.name()}${since}`, `${status.link.text || 'It cannot be reached'}. It is tried again until it works.`];
  const own = readings.troubles.find(one => one.part === 'device');
  if (own) return [`The ${page.name()} reports ${own.words}`, ''];
  const stuck = status.components.find(one => one.activity === 'stuck');
  return stuck ? [`${stuck.name} is stuck`, 'It is given up if it does not go on.'] : null;
}

function trouble(page) {
  const parts = page.readings.troubles.filter(one => !['link', 'record', 'device'].includes(one.part)).map(one => one.part);
  const violated = page.events.findLast(isViolation);
  if (violated) return [`${violated.event.slice('violation of '.length)}, ${clock(violated.at)}`, 'bad'];
  if (parts.length) return [`in ${parts.join(', ')}`, 'warn'];
  const { failed, dropped } = page.status.events;
  if (dropped) return [`${plural(dropped, 'event')} lost`, 'warn'];
  const last = page.events.findLast(one => one.outcome === 'failed');
  if (failed) return [`${plural(failed, 'event')} failed${last ? `, ${clock(last.at)}` : ''}`, 'warn'];
  return ['none', 'good'];
}

function facts(page) {
  const { status, readings } = page;
  const device = page.drawn('original', status.originalState);
  const shown = readings.device.filter(one => one.name !== 'error').slice(0, 2);
  const some = [[`${page.title()} itself`, status.doubt ? 'not certain' : device, status.doubt ? 'bad' : '']];
  some.push(...shown.map(one => [one.name, one.value, '']));
  if (status.link && shown.length < 2) some.push(['link', status.link.up ? 'up' : 'down', status.link.up ? 'good' : 'bad']);
  some.push(['trouble', ...trouble(page)]);
  return some;
}

function fact([term, value, className]) {
  const shown = element('dd', '', className);
  const share = term === 'battery' && /^(\d+)(\.\d+)? %$/.exec(value);
  if (share) {
    const cell = holding('span', 'cell', document.createElement('i'));
    cell.style.setProperty('--part', `${Math.min(100, Number(share[1]))}%`);
    shown.append(cell);
  }
  shown.append(value);
  return holding('div', '', element('dt', term[0].toUpperCase() + term.slice(1)), shown);
}

export function showNow(page) {
  const { status } = page;
  const wrong = alarm(page);
  $('alarm').hidden = !wrong;
  if (wrong) {
    say($('alarm').querySelector('b'), wrong[0]);
    say($('alarm').querySelector('p'), wrong[1]);
  }
  const made = chain(page);
  renew($('chain'), made.map(one => [one.className, one.textContent]), () => made);
  say($('says'), sentence(page));
  say($('selves'), alsoByItself(page));
  const known = facts(page);
  renew($('facts'), known, () => known.map(fact));
  count(page);
  const [timer] = timers(page);
  const heard = status.doubt ? `${doubted(page).join(' or ')}, not certain which` : page.here();
  const after = !status.doubt && timer ? `, then ${timer.target}` : '';
  say($('told-now'), `${status.loop === 'running' ? '' : 'Stopped. '}${wrong ? `${wrong[0]}. ` : ''}${heard}${after}`);
}

// The time that is left, by the converter's clock: from its last word on, as long as it is heard.
export function count(page) {
  const place = $('chain').querySelector('.left');
  const [timer] = page.status && place ? timers(page) : [];
  if (!timer) return;
  const since = Math.min(MOST_COUNTED, performance.now() - page.heardAt);
  const remaining = Math.max(0, timer.left - since);
  say(place, left(remaining, timer.whole || timer.left));
  const share = timer.whole ? 1 - remaining / timer.whole : 0;
  $('chain').querySelector('.track i').style.setProperty('--part', Math.min(1, Math.max(0, share)).toFixed(4));
}
