// Requests to the studio's server, which keeps nothing: each one brings its texts.

const ALIVE = '/api/files'; // what any studio answers

let heard = () => {};

// Calls back with 'up', 'ended' (no answer) or 'locked' (no longer admitted) after each request.
export function onLink(listener) { heard = listener; }

export class Refused extends Error {
  constructor(status, answer) {
    super(answer.refused ?? answer.error ?? `the studio answered ${status}`);
    this.status = status;
    this.answer = answer;
  }
}

export async function ask(method, path, body, signal) {
  let response;
  try {
    response = await fetch(path, { method, signal, body: body === undefined ? undefined : JSON.stringify(body) });
  } catch (failure) {
    if (signal?.aborted) throw failure;
    const alive = path !== ALIVE && (await fetch(ALIVE).then(() => true, () => false));
    if (!alive) heard('ended');
    throw new Refused(alive ? 500 : 0, { error: alive ? 'the studio has failed at this' : 'the studio has ended' });
  }
  if (response.status === 401) heard('locked');
  else heard('up');
  const text = await response.text();
  const answer = text.startsWith('{') ? JSON.parse(text) : { error: text.trim() };
  if (!response.ok) throw new Refused(response.status, answer);
  return answer;
}

export async function admit(token) {
  const response = await fetch('/session', { method: 'POST', body: token });
  return response.ok;
}

// Questions of which only the last one matters: an older answer is never seen.
export class Latest {
  #control = new AbortController();

  // The answer, or null if another question was asked meanwhile.
  async ask(path, body) {
    const mine = this.forget();
    try {
      const answer = await ask('POST', path, body, mine.signal);
      return mine.signal.aborted ? null : answer;
    } catch (failure) {
      if (mine.signal.aborted) return null;
      throw failure;
    }
  }

  forget() {
    this.#control.abort();
    this.#control = new AbortController();
    return this.#control;
  }
}
