/*
 * The paper's own mechanism (its Algorithm 1 and the converter of its listing) in place of inputs.pml and turn.pml, in the same
 * world: one event at a time, and events that arrive meanwhile are lost; no step waits for the device; the original model moves by
 * the incoming event when it is decided (line 9); the device's own actions are events like others; timers and functions are not
 * bound to a visit; no state survives the process, and other models start in their initial states.
 */

inline opened() {
  open = 1;
  if
  :: over -> enter()
  :: else -> skip
  fi
}

inline closing() { open = 0 }

inline closed() { leave() }

inline recovered() {
  forget_all();
  device_at = INITIAL_DEVICE;
  system_at = INITIAL_SYSTEM;
  open = 0;
  over = 1;
  armed = 0
}

inline forget_all() {
  do
  :: waiting > 0 -> take_out(0)
  :: else -> break
  od;
  end_work()
}

inline observed_heard(event, source_, visit_, acted_) {
  make(HEARD, event, source_, visit_, 0);
  observed_count++;
  if
  :: open && !busy && waiting == 0 -> number = 1; next_one.id = 1; append()
  :: else -> skip
  fi
}

inline observed_asked(event, visit_) { observed_heard(event, FUNCTION, visit_, 0) }

inline observed_found(state, late) { skip }

inline timer_due(visit_) {
  armed = 0;
  observed_heard(timer_table[IX(pair, 0, system_at, 0)], TIMER, PRESENT, 0)
}

inline ready() {
  COPY(work, line[0]);
  take_out(0);
  busy = 1;
  must(VISIT, work.visit != FORMER)
}

inline end_work() {
  busy = 0;
  decided = 0;
  plan = 0;
  taken = 0;
  step_source = 0;
  stage = READY;
  directive = NOTHING;
  CLEAR(work)
}

inline planned(id_, plan_, start, system) {
  plan = plan_;
  decided = 1;
  step_source = device_at;
  system_at = AFTER(plan);
  device_at = (KIND(plan) != NOT_ACCEPTABLE && OWN(device_at, work.what) != NONE -> OWN(device_at, work.what) : device_at);
  if
  :: LEAVES(plan) -> enter()
  :: else -> skip
  fi;
  go_on()
}

inline go_on() {
  if
  :: NEXT_STEP != NONE -> directive = SEND
  :: else -> end_work(); ended()
  fi
}

inline sending(id_) {
  stage = SENDING;
  step_source = device_at
}

inline sent(id_, in_order) {
  if
  :: busy && stage == SENDING ->
    stage = READY;
    taken++;
    go_on()
  :: else -> skip
  fi
}

inline failed(id_) { end_work(); ended() }

inline given_up(id_) { end_work(); ended() }

inline located(id_, state) { skip }

inline changed() { skip }

#define UNHINDERED (!busy)

inline evolved() {
  pair = 1 - pair;
  device_at = INITIAL_DEVICE;
  system_at = INITIAL_SYSTEM;
  forget_all();
  enter()
}
