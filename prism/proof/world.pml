/*
 * The environment of a core: the real device, its adapter, the components of the loop, and all faults. Actions that may occur
 * without limit are processes under weak fairness; the number of all others is bounded (PRESSES and so on). See
 * org.evoloop.engine.Moves and its neighbours in the core's tests for the same world.
 */

#define CLOSED 0
#define OPEN 1
#define CLOSING 2

/* Unreported occurrences at the device, in order: the effect of a step, or a fact. */
#define MOST_UNTOLD 2

byte device = INITIAL_DEVICE;
bit acting; /* the device is busy with a command, and loses commands sent meanwhile */
byte untold;
byte token[MOST_UNTOLD];

byte flight; /* the number of the occurrence whose step is in transit */
byte flight_event;
bit landed;
byte stray; /* the same for an abandoned step that may still take effect */
byte stray_event;

byte answer; /* the state that the device reported */
bit planning; /* analyze has decided, on the state at that time */
int made;
byte made_at;
byte made_in;

byte phase = CLOSED;
bit swap; /* other models are to take over */
bit tried; /* this was attempted since the last event */

byte presses_left = PRESSES;
byte owns_left = OWNS;
byte jumps_left = JUMPS;
byte raises_left = RAISES;
byte asks_left = ASKS;
byte stops_left = STOPS;
byte fails_left = FAILS;
byte give_ups_left = GIVE_UPS;
byte ends_left = ENDS;
byte swaps_left = SWAPS;
byte changes_left = CHANGES;

#define ROOM (waiting + 2 < PLACES)
#define IS_FACT_FOUND(t) ((t) > FOUND_IN && (t) < EFFECT_OF)
#define SEEN_UNTOLD (IS_FACT_FOUND(token[0]) || IS_FACT_FOUND(token[1]))

/* The device's reaction to `event` in its state. */
inline takes_by_itself(event) { device = (OWN(device, event) != NONE -> OWN(device, event) : device) }

inline happened(what_) {
  token[untold] = what_;
  untold++
}

inline forget_token(place) {
  if
  :: (place) == 0 && untold > 1 -> token[0] = token[1]
  :: else -> skip
  fi;
  untold--;
  token[untold] = 0
}

/* The effect of the abandoned step will never be reported. */
inline hide_effect() {
  if
  :: untold > 0 && token[0] > EFFECT_OF -> forget_token(0)
  :: else ->
    if
    :: untold > 1 && token[1] > EFFECT_OF -> forget_token(1)
    :: else -> skip
    fi
  fi
}

inline not_sent() {
  flight = 0;
  flight_event = 0;
  landed = 0
}

inline no_plan() {
  planning = 0;
  made = 0;
  made_at = 0;
  made_in = 0
}

/* The component whose turn it is is abandoned, with its step. */
inline let_go(hidden_) {
  if
  :: flight && !landed -> stray = flight; stray_event = flight_event
  :: else -> skip
  fi;
  if
  :: hidden_ -> hide_effect()
  :: else -> skip
  fi;
  not_sent();
  no_plan();
  answer = 0
}

hidden byte told;
hidden byte asked_of;

#ifdef IN_ORDER
#define KEEPS_ORDER 1
#else
#define KEEPS_ORDER 0
#endif

#ifdef NO_BACK_PRESSURE
#define IS_READY true
#else
#define IS_READY (!acting)
#endif

inline device_gets(event) {
  takes_by_itself(event);
  acting = 1;
  landed = 1;
  happened(EFFECT_OF + flight)
}

/* The adapter does not know that the device was busy, and reports the effect. */
inline lost_at_device() {
  landed = 1;
  happened(EFFECT_OF + flight)
}

inline tell(place) {
  told = token[place];
  forget_token(place);
  if
  :: told > EFFECT_OF ->
    if
    :: flight == told - EFFECT_OF -> not_sent()
    :: else -> skip
    fi;
    printf("> sent %d %d\n", told - EFFECT_OF, KEEPS_ORDER);
    sent(told - EFFECT_OF, KEEPS_ORDER)
  :: told > FOUND_IN && told < EFFECT_OF ->
    stray = 0;
    stray_event = 0;
    printf("> found %d 0\n", told - FOUND_IN);
    observed_found(told - FOUND_IN, 0)
  :: else ->
    printf("> own %d %d\n", told, 1 - is_own_table[told]);
    observed_heard(told, DEVICE, ANY, 1 - is_own_table[told])
  fi
}

inline answered() {
  asked_of = work.id;
  told = answer;
  answer = 0;
  located(asked_of, told)
}

inline announce() {
  directive = NOTHING;
  asked_of = work.id;
  told = NEXT_STEP;
  printf("> sending %d %d\n", asked_of, told);
  nothing_again();
  sending(asked_of);
  if
  :: stage == SENDING ->
    must(SENT, step_source == device_at);
    flight = asked_of;
    flight_event = told;
    landed = 0
  :: else -> skip
  fi
}

inline try_swap() {
  tried = 1;
  if
  :: UNHINDERED -> printf("> evolved\n"); evolved(); swap = 0; tried = 0
  :: else -> skip
  fi
}

/* The present visit, or a former one whose function has not noticed that it is over. */
inline choose_visit() {
  if
  :: visit = PRESENT
  :: visited > 1 -> visit = FORMER
  fi
}

inline end_process(hidden_) {
  ends_left--;
  phase = CLOSED;
  remember_plan();
  let_go(hidden_);
  swap = 0;
  tried = 0;
  printf("> recovered\n");
  recovered();
  nothing_lost()
}

#define timer_waits() ((waiting > 0 && line[0].source == TIMER && line[0].visit == PRESENT) || (waiting > 1 && line[1].source == TIMER && line[1].visit == PRESENT) || (waiting > 2 && line[2].source == TIMER && line[2].visit == PRESENT))

/* ---- processes ---- */

proctype Device() {
  do
  :: WHEN(flight && !landed && !acting && untold < MOST_UNTOLD, printf("the device takes %d\n", flight_event); device_gets(flight_event))
  :: WHEN(flight && !landed && acting && untold < MOST_UNTOLD, printf("the device loses %d\n", flight_event); lost_at_device())
  :: WHEN(acting, printf("the device is ready again\n"); acting = 0)
  od
}

proctype Adapter() {
  do
  :: WHEN(untold > 0 && ROOM, tell(0))
#ifndef IN_ORDER
  :: WHEN(untold > 1 && ROOM && token[0] > EFFECT_OF && token[1] < EFFECT_OF, tell(1))
#endif
  od
}

/* The loop: analyze, plan and execute. */
proctype Carrier() {
  do
  :: WHEN(phase == OPEN && !busy && swap && !tried, try_swap())
  :: WHEN(phase == OPEN && (!busy || stage == INTERRUPTED) && (!swap || tried) && (waiting > 0 || busy || owed), tried = 0; printf("> ready\n"); ready())
  :: WHEN(busy && !decided && !planning, decide(); planning = 1; made = code; made_at = at_state; made_in = system_at)
  :: WHEN(busy && !decided && planning, printf("> planned %d %d %d %d\n", work.id, made, made_at, made_in); planned(work.id, made, made_at, made_in); no_plan())
  :: WHEN(busy && stage == RESUMED, printf("> planned %d %d %d %d\n", work.id, plan, device_at, system_at); planned(work.id, plan, device_at, system_at))
  :: WHEN(busy && directive == SEND && stage == READY && !flight && IS_READY, announce())
  :: WHEN(busy && directive == LOCATE && KIND(plan) == INQUIRY && stage == READY && (answer || !CAN_LOCATE), directive = NOTHING; printf("> located %d %d\n", work.id, answer); answered())
  :: WHEN(busy && directive == LOCATE && KIND(plan) == INQUIRY && stage == READY && CAN_LOCATE && !answer && untold == 0, printf("the device answers that it is in %d\n", device); answer = device; stray = 0; stray_event = 0)
  od
}

#ifndef A_SWAP_HAS_NO_DEADLINE
proctype Deadline() {
  do
  :: WHEN(swap, printf("the swap is given up\n"); swap = 0; tried = 0)
  od
}
#endif

proctype Timers() {
  do
  :: WHEN(armed && !over && open && ROOM && !timer_waits(), printf("> timer\n"); timer_due(PRESENT))
  od
}

proctype Operator() {
  do
  :: WHEN(phase == CLOSED, phase = OPEN; printf("> opened\n"); opened())
  :: WHEN(phase == CLOSING && (!busy || stage == INTERRUPTED), phase = CLOSED; printf("> closed\n"); closed())
  od
}

/* ---- bounded actions ---- */

proctype People() {
  byte event;
end:
  do
  :: atomic { presses_left > 0 && ROOM -> choose_button(); WHEN(true, presses_left--; printf("> press %d\n", event); observed_heard(event, BUTTON, ANY, 0)); event = 0 }
  od
}

proctype Functions() {
  byte event;
  byte visit;
end:
  do
  :: atomic { raises_left > 0 && ROOM && !(over && system_at == INITIAL_SYSTEM && !stepped && !open) -> choose_raised(); choose_visit(); WHEN(true, raises_left--; printf("> raise %d %d\n", event, visit); observed_heard(event, FUNCTION, visit, 0)); event = 0; visit = 0 }
  :: atomic { asks_left > 0 && ROOM && !(over && system_at == INITIAL_SYSTEM && !stepped && !open) -> choose_asked(); choose_visit(); WHEN(true, asks_left--; printf("> ask %d %d\n", event, visit); observed_asked(event, visit)); event = 0; visit = 0 }
  od
}

proctype DeviceByItself() {
  byte event;
end:
  do
  :: atomic { owns_left > 0 && untold < MOST_UNTOLD && CAN_ACT -> choose_own(); WHEN(true, owns_left--; printf("the device does %d by itself\n", event); takes_by_itself(event); happened(event)); event = 0 }
  :: atomic { jumps_left > 0 && untold < MOST_UNTOLD -> choose_device_state(); WHEN(true, jumps_left--; printf("the device gets to %d\n", event); device = event; stray = 0; stray_event = 0; happened(FOUND_IN + event)); event = 0 }
  :: atomic { jumps_left > 0 && stepped && ROOM -> choose_device_state(); WHEN(true, jumps_left--; printf("> found %d 1\n", event); observed_found(event, 1)); event = 0 }
  :: WHEN(stray && untold < MOST_UNTOLD && !acting, printf("the device takes %d, which was given up\n", stray_event); takes_by_itself(stray_event); happened(EFFECT_OF + stray); stray = 0; stray_event = 0)
  :: WHEN(stray && !acting && !SEEN_UNTOLD, printf("the device takes %d, which was given up, and nobody is told\n", stray_event); takes_by_itself(stray_event); stray = 0; stray_event = 0)
  od
}

proctype Faults() {
end:
  do
  :: WHEN(fails_left > 0 && busy && stage != INTERRUPTED && !(flight && landed), fails_left--; not_sent(); no_plan(); answer = 0; printf("> failed %d\n", work.id); asked_of = work.id; failed(asked_of))
  :: WHEN(give_ups_left > 0 && busy && stage != INTERRUPTED, give_ups_left--; let_go(false); printf("> given_up %d\n", work.id); asked_of = work.id; given_up(asked_of))
  :: WHEN(give_ups_left > 0 && busy && stage != INTERRUPTED && flight && landed && !SEEN_UNTOLD, give_ups_left--; let_go(true); printf("> given_up %d\n", work.id); asked_of = work.id; given_up(asked_of))
  :: WHEN(ends_left > 0, end_process(false))
  :: WHEN(ends_left > 0 && flight && landed && !SEEN_UNTOLD, end_process(true))
  :: WHEN(stops_left > 0 && phase == OPEN, stops_left--; phase = CLOSING; printf("> closing\n"); closing())
  :: WHEN(changes_left > 0, changes_left--; printf("> changed\n"); changed())
  :: WHEN(swaps_left > 0 && !swap, swaps_left--; swap = 1; tried = 0; printf("a swap is asked for\n"))
  od
}

