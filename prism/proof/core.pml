/*
 * The converter's core, as org.evoloop.engine.Core has it: each of its inputs is an inline of the same name, and each is a
 * deterministic function of the state. Visits and steps have no numbers here: the state only records whether a visit is the
 * present one, and whether a step has been sent since.
 *
 * Not modelled, since the paper's models have none: effects, guards, deferred events, composite states. A state has one timer
 * at most. The world (world.pml) never fills the places for facts, 1,024 more than the queue's capacity.
 */

#define NONE 0

/* The kinds of occurrences. */
#define HEARD 1
#define FOUND 2
#define ASKED 3
#define EVOLVED 4
#define IN_DOUBT 5

/* The source of an occurrence. */
#define BUTTON 1
#define DEVICE 2
#define TIMER 3
#define FUNCTION 4

/* The visit of a state to which it belongs. */
#define ANY 0
#define PRESENT 1
#define FORMER 2

/* The stage of the occurrence in progress. */
#define READY 0
#define SENDING 1
#define INTERRUPTED 2
#define RESUMED 3

/* A doubt: the state is unknown, or the device has reported it since, but the step's effect may still be reported. */
#define UNSETTLED 1
#define SETTLED 2
/* In what is told, those that remember the decision which they interrupted: an unsettled one; one that a report has settled. */
#define REMEMBERING 3
#define REPORTED 4

/* The number of steps sent since a doubt arose. */
#define SAME 0
#define LATER 1
#define NEVER_KNOWN 2

/* The properties. A trail shows their numbers. */

#define RECORD 1
#define ONCE 2
#define VISIT 3
#define AGAIN 4
#define SENT 5
#define STUCK 6
#define CROWDED_OUT 7
#define TOGETHER 8
#define QUESTION 9
#define HEARD_FIRST 10
#define NEEDED 11
#define REACHED 12
#define STARTS 13
#define RUNS 14
#define RESUMES 15
#define URGENT 16
#define ANOTHER 17

typedef Pending {
  byte id;
  byte kind;
  byte what; /* an event, or a state in which the device was found */
  byte source;
  byte visit;
  byte from; /* the device's state before this fact, which the record has followed */
  byte own; /* the target of the device's own step */
  byte attempts;
  bit acted; /* the device has acted on it by itself */
  bit later /* a step has been sent since it was observed */
};

/* A fact: an event on which the device acted, or FOUND_IN + the state in which it was found. */
#define FOUND_IN 100

bit pair; /* the current models: 0 the initial ones, 1 the others */
bit open;
byte device_at = INITIAL_DEVICE; /* the record of the device's state */
byte system_at = INITIAL_SYSTEM;

byte doubt;
byte doubt_id;
byte doubt_event;
byte doubt_source;
byte doubt_steps;
byte doubt_facts;
byte doubt_fact[FACTS];
int doubt_plan; /* the decision that it interrupted, if that leads to a new state which needs the device somewhere: Doubt.interrupted */
byte doubt_system; /* the new model's state then */

bit stepped; /* whether any step has been sent */
bit owed; /* whether the new model has to follow the device once no fact waits: Ledger.followOwed */
bit over = 1; /* whether the visit has ended */
bit armed; /* whether the visit's timer runs */
bit start_owed; /* whether the visit's function has yet to be started: Stay.startOwed */
bit runs; /* whether that of a state which needs the device somewhere has been started */

byte waiting;
Pending line[PLACES];

bit busy;
Pending work;
bit decided;
bit late; /* a step had been sent between the observation of a fact and its decision */
int plan;
byte stage;
byte taken;
byte step_source; /* the source state of the next step */
byte facts;
byte fact[FACTS];

/* The core's directives to its components. */
#define NOTHING 0
#define SEND 1
#define LOCATE 2
byte directive;

/* The numbers of occurrences that were observed and that ended during the current input. */
hidden byte observed_count, ended_count;

/* Whether anything happened during the current input that may leave device and new model in states that do not go together. */
hidden byte may_part;

/* Scratch. */
hidden Pending next_one;
hidden byte i, j, k, place, at_state, before_state, target, number;
hidden byte begun; /* visits that had begun before what happens now */
hidden byte entries; /* visits that began during the current input */
hidden byte kept_fact[FACTS];
hidden byte noted_id, noted_event, noted_source, noted_system, ended_kind, timer;
hidden int noted_plan;
hidden byte flag, completes, was_in_doubt, sure, as_planned, goes_on, leaves, possible, was_sending;
hidden int code;

#define COPY(to, from_) to.id = from_.id; to.kind = from_.kind; to.what = from_.what; to.source = from_.source; \
  to.visit = from_.visit; to.from = from_.from; to.own = from_.own; to.attempts = from_.attempts; \
  to.acted = from_.acted; to.later = from_.later

#define CLEAR(one) one.id = 0; one.kind = 0; one.what = 0; one.source = 0; one.visit = 0; one.from = 0; one.own = 0; \
  one.attempts = 0; one.acted = 0; one.later = 0

/* ---- decisions ---- */

#define KIND(d) ((d) & 7)
#define LEAVES(d) (((d) >> 3) & 1)
#define AFTER(d) (((d) >> 4) & 15)
#define STEP(d, n) (((d) >> (8 + 4 * (n))) & 15)
#define HAS_TRANSITION(d) (((d) >> 24) & 1)
#define WITHOUT_STEPS(d) ((d) & ((1 << 24) | 255))
#define NOT_ACCEPTABLE 0
#define EXISTING 1
#define NEW 2
#define IMPOSSIBLE 3
#define SEND_ONLY 4
#define INQUIRY 5
#define RESYNCHRONIZATION 6

#define IS_TAKEN(d) (KIND(d) == EXISTING || KIND(d) == NEW)
#define DECISION(table, device, system, event) table[IX(pair, device, system, event)]
#define HAS_HAPPENED(one) (one.from != NONE || one.acted || one.kind == FOUND || one.kind == EVOLVED || one.kind == IN_DOUBT)
#if defined(HAS_URGENT) && !defined(WHAT_IS_URGENT_HAS_NO_PLACE_OF_ITS_OWN)
#define MAY_BE_LOST(one) (!HAS_HAPPENED(one) && one.source == BUTTON && !IS_URGENT(one))
#else
#define MAY_BE_LOST(one) (!HAS_HAPPENED(one) && one.source == BUTTON)
#endif
#define NEXT_STEP STEP(plan, taken)

/* Rules.decide: stores the decision on the occurrence in progress in `code`, and the state where planning begins in `at_state`. */
inline decide() {
  at_state = device_at;
  if
  :: work.kind == HEARD && work.from == NONE -> code = DECISION(asked_table, device_at, system_at, work.what)
  :: work.kind == HEARD && work.from != NONE ->
    at_state = (OWN(work.from, work.what) != NONE -> OWN(work.from, work.what) : work.from);
    code = DECISION(acted_table, work.from, system_at, work.what);
    if
    :: at_state == device_at -> skip
    :: at_state != device_at ->
      at_state = device_at;
      code = DECISION(react_table, device_at, system_at, work.what);
      if
      :: !work.later && work.own != NONE && IS_TAKEN(DECISION(react_table, work.own, system_at, work.what)) &&
         STEP(DECISION(react_table, work.own, system_at, work.what), 0) == NONE ->
        code = DECISION(react_table, work.own, system_at, work.what)
      :: else -> skip
      fi
    fi
  :: work.kind == FOUND -> find(device_at)
  :: work.kind == ASKED -> code = DECISION(ask_table, device_at, system_at, work.what)
  :: work.kind == EVOLVED -> code = settle_table[IX(pair, device_at, system_at, 0)]
  :: work.kind == IN_DOUBT -> code = INQUIRY + 16 * system_at
  fi
}

/* DecisionTable.find: stores the new model's next state when the device is found in `state` in `code`. */
inline find(state) {
  target = find_table[IX(pair, state, system_at, 0)];
  code = RESYNCHRONIZATION + 16 * target + (target != system_at -> 8 : 0)
}

/* Whether the decision table has this pair of states, so that the new model would not follow if the device were found there. */
#define STANDS_TOGETHER(device, system) (find_table[IX(pair, device, system, 0)] == system)

/* Only a question to the device comes before an event that waits to be decided again. */
#define RETRY_WAITS (line[0].attempts > 0 || line[1].attempts > 0)

/* Ledger.followUnless: what was in doubt and waits to be decided again may have brought the device where it is. */
#define HOLDS(id_) (line[0].id == (id_) || line[1].id == (id_) || line[2].id == (id_))
#ifdef WHAT_IS_DECIDED_AGAIN_IS_TAKEN_FOR_ANOTHER_PRESS
#define FOLLOW_UNLESS(together) owed = owed || !(together)
#else
#define FOLLOW_UNLESS(together) owed = owed || (!(together) && !(doubt && HOLDS(doubt_id)))
#endif

/* Ledger.followIfApart */
inline follow_if_apart() { FOLLOW_UNLESS(STANDS_TOGETHER(device_at, system_at)) }

/* DecisionTable.isWhereNeeded: whether a new state needs the device elsewhere. */
#define NEEDS_IT_ELSEWHERE(device, system) elsewhere_table[IX(pair, device, system, 0)]
#define IS_ELSEWHERE NEEDS_IT_ELSEWHERE(device_at, system_at)

/* The function of the new model's state: none, one that runs wherever the device is, or one that needs it somewhere. */
#define WHAT_RUNS function_table[IX(pair, 0, system_at, 0)]
#define ANYWHERE 1
#define SOMEWHERE 2

#include "urgent.pml"

/* ---- numbers: the lowest unused one, so that they do not grow without bound ---- */

inline give_number() {
  observed_count++;
#ifdef COUNTED
  counted++;
  number = counted;
#else
  number = 0;
  flag = 1;
  do
  :: flag ->
    number++;
    flag = (busy && work.id == number) || (doubt && doubt_id == number) || OUTSIDE(number);
    i = 0;
    do
    :: i < waiting -> flag = flag || line[i].id == number; i++
    :: else -> break
    od
  :: else -> break
  od;
#endif
  printf("new %d\n", number)
}

/* ---- the queue ---- */

/* Adds `next_one`. */
inline append() {
  assert(waiting < PLACES);
  COPY(line[waiting], next_one);
  waiting++
}

inline prepend() { insert(0) }

inline insert(place) {
  assert(waiting < PLACES);
  i = waiting;
  do
  :: i > place -> COPY(line[i], line[i - 1]); i--
  :: else -> break
  od;
  COPY(line[place], next_one);
  waiting++
}

/* Line.putBack: what has begun has its turn again before all others but a question to the device. */
inline put_back() {
#ifdef WHAT_IS_DECIDED_AGAIN_COMES_BEFORE_A_QUESTION
  prepend()
#else
  j = waiting > 0 && line[0].kind == IN_DOUBT;
  insert(j)
#endif
}

inline take_out(place) {
  i = place;
  do
  :: i + 1 < waiting -> COPY(line[i], line[i + 1]); i++
  :: else -> break
  od;
  waiting--;
  CLEAR(line[waiting])
}

inline make(kind_, what_, source_, visit_, acted_) {
  CLEAR(next_one);
  next_one.kind = kind_;
  next_one.what = what_;
  next_one.source = source_;
  next_one.visit = visit_;
  next_one.acted = acted_
}

/* Ledger.ended: where something has ended with the device elsewhere than the new model's state needs it, the new model follows. */
inline ended() {
  ended_count++
#ifndef A_DEVICE_ELSEWHERE_IS_NOT_FOLLOWED
  ;
  FOLLOW_UNLESS(!IS_ELSEWHERE)
#endif
}

inline not_heard() { ended_count++ }

#ifdef FACTS_TAKE_UP_CONTROLLERS_PLACES
#define PLACES_TAKEN waiting
#else
#define PLACES_TAKEN j
#endif

/* Arrivals.enqueue: `j` is the number of controllers' events that wait. */
inline enqueue(from_, own_) {
  give_number();
  next_one.id = number;
  next_one.from = from_;
  next_one.own = own_;
  i = 0;
  j = 0;
  do
  :: i < waiting -> j = j + MAY_BE_LOST(line[i]); i++
  :: else -> break
  od;
  if
  :: MAY_BE_LOST(next_one) && !(PLACES_TAKEN < CAPACITY || (!busy && PLACES_TAKEN < 1)) ->
    must(CROWDED_OUT, j >= CAPACITY);
#ifdef HAS_URGENT
    must(URGENT, !IS_URGENT(next_one));
#endif
    not_heard()
  :: else -> append()
  fi
}

/* ---- doubt ---- */

inline ask_where() {
  if
  :: doubt == UNSETTLED && !(waiting > 0 && line[0].kind == IN_DOUBT) ->
    make(IN_DOUBT, NONE, DEVICE, ANY, 0);
    give_number();
    next_one.id = number;
    prepend()
  :: else -> skip
  fi
}

/* Ledger.doubt: `k` is the number of facts; they are in `kept_fact`. */
inline doubt_step(number_, event, source) {
  doubt_steps = (doubt == NONE -> SAME : NEVER_KNOWN);
  doubt = UNSETTLED;
  doubt_id = number_;
  doubt_event = event;
  doubt_source = source;
  doubt_facts = k;
  doubt_plan = noted_plan;
  doubt_system = (noted_plan != 0 -> noted_system : 0);
  i = 0;
  do
  :: i < FACTS -> doubt_fact[i] = (i < k -> kept_fact[i] : 0); i++
  :: else -> break
  od;
  ask_where()
}

inline forget_plan() {
  doubt_plan = 0;
  doubt_system = 0
}

inline no_doubt() {
  doubt = NONE;
  doubt_id = 0;
  doubt_event = 0;
  doubt_source = 0;
  doubt_steps = 0;
  doubt_facts = 0;
  forget_plan();
  i = 0;
  do
  :: i < FACTS -> doubt_fact[i] = 0; i++
  :: else -> break
  od
}

/* Ledger.completed: whether the interrupted plan has come to its end in `state`, and the new model has not moved since. */
#define COMPLETES(state) (doubt_plan != 0 && doubt_system == system_at && !NEEDS_IT_ELSEWHERE(state, AFTER(doubt_plan)))

/* A device that has reported its state, which completes what was interrupted, and has not had its turn. */
#define IS_REPORTED (doubt == SETTLED && doubt_plan != 0)

/* A doubt that is about no step ends when it is settled. */
inline settle_doubt() {
  if
  :: doubt == UNSETTLED && doubt_event == NONE -> no_doubt()
  :: doubt == UNSETTLED && doubt_event != NONE -> doubt = SETTLED; forget_plan()
  :: else -> skip
  fi
}

/* Ledger.contradicted: the device has reported what it cannot have done from its recorded state. */
inline contradicted() {
  owed = 1;
  if
  :: doubt == UNSETTLED -> skip
  :: else ->
    doubt = UNSETTLED;
    doubt_steps = NEVER_KNOWN;
    forget_plan();
    ask_where()
  fi
}

inline happens_meanwhile(what_) {
  if
#ifdef WHAT_HAPPENS_DURING_A_STEP_IS_FORGOTTEN
  :: false -> skip
#else
  :: busy && (stage == SENDING || (decided && KIND(plan) == INQUIRY)) -> add_fact(what_)
#endif
  :: else -> skip
  fi;
  if
  :: doubt -> assert(doubt_facts < FACTS); doubt_fact[doubt_facts] = what_; doubt_facts++
  :: else -> skip
  fi
}

inline add_fact(what_) {
  assert(facts < FACTS);
  fact[facts] = what_;
  facts++
}

/* Overlap.takes: stores the target of the step `event` from `state` in `target`. */
inline takes(state, event) {
  target = (OWN(state, event) != NONE -> OWN(state, event) : state)
}

inline follows(state, what_) {
  state = (what_ > FOUND_IN -> what_ - FOUND_IN : (OWN(state, what_) != NONE -> OWN(state, what_) : state))
}

/* Overlap.alwaysEndsIn for the `k` facts in `kept_fact`; the result is in `sure`. */
inline always_ends_in(end, event, source) {
  sure = 1;
  before_state = source;
  i = 0;
  do
  :: i <= k ->
    at_state = (OWN(before_state, event) != NONE -> OWN(before_state, event) : before_state);
    j = i;
    do
    :: j < k -> follows(at_state, kept_fact[j]); j++
    :: else -> break
    od;
    sure = sure && at_state == end;
    if
    :: i < k -> follows(before_state, kept_fact[i])
    :: else -> skip
    fi;
    i++
  :: else -> break
  od
}

/* DecisionTable.isImpossible: the device has the event in other states only. */
#define IS_IMPOSSIBLE(state, event) (has_table[event] && OWN(state, event) == NONE)

/*
 * Overlap.impossible: `possible` says whether the device can have done the `k` facts in `kept_fact` from `source` on, in some
 * order with the step `event`, or, if `last`, before it.
 */
inline can_have_happened(source, event, last) {
  possible = 0;
  i = (last -> k : 0);
  do
  :: i <= k ->
    at_state = source;
    flag = 1;
    j = 0;
    do
    :: j < k ->
      if
      :: j == i && (event) != NONE -> at_state = (OWN(at_state, event) != NONE -> OWN(at_state, event) : at_state)
      :: else -> skip
      fi;
      flag = flag && !(kept_fact[j] < FOUND_IN && IS_IMPOSSIBLE(at_state, kept_fact[j]));
      follows(at_state, kept_fact[j]);
      j++
    :: else -> break
    od;
    possible = possible || flag;
    i++
  :: else -> break
  od
}

/* ---- visits ---- */

inline leave() {
  over = 1;
  start_owed = 0;
  runs = 0
}

/* No function runs while the device is sent to where the new model is: the state is entered after that. */
#define SETTLING ((busy && work.kind == EVOLVED) || line[0].kind == EVOLVED || line[1].kind == EVOLVED || line[2].kind == EVOLVED)

inline enter() {
  armed = timer_table[IX(pair, 0, system_at, 0)] != NONE;
  if
  :: SETTLING -> skip
  :: else ->
    entries++;
    over = 0;
    another_visit()
  fi
}

/* Occurrences of the present visit become those of a former one. */
inline another_visit() {
  i = 0;
  do
  :: i < waiting -> line[i].visit = (line[i].visit == PRESENT -> FORMER : line[i].visit); i++
  :: else -> break
  od;
  work.visit = (work.visit == PRESENT -> FORMER : work.visit)
}

/* Ledger.enterAsLeft: the visit's waiting occurrences pass to the next visit. */
inline enter_as_left() {
  i = 0;
  do
  :: i < waiting ->
    armed = armed && !(line[i].kind == HEARD && line[i].source == TIMER && line[i].visit == PRESENT &&
                       line[i].what == timer_table[IX(pair, 0, system_at, 0)]);
    i++
  :: else -> break
  od;
  armed = armed && timer_table[IX(pair, 0, system_at, 0)] != NONE;
  if
  :: SETTLING -> skip
  :: else -> entries++; over = 0
  fi
}

inline enter_again(kind_) {
#ifdef HAS_URGENT
  see_urgent();
#endif
  if
  :: over && open && !(waiting > 0 && line[0].attempts > 0) && !SETTLING && !IS_ELSEWHERE UNLESS_URGENT ->
    if
    :: kind_ == EVOLVED && WHAT_RUNS != SOMEWHERE -> enter_as_left()
    :: else -> enter()
    fi
  :: else -> skip
  fi
}

/*
 * Ledger.start: starts the function of a visit that began after `begun` visits. If it needs the device somewhere, it is started
 * once the record is certain, no fact waits, the device is there, and the converter is open.
 */
inline start_function() {
  count_facts();
  start_owed = start_owed || (entries != begun && WHAT_RUNS == SOMEWHERE);
  if
#ifdef A_FUNCTION_IS_STARTED_AT_ONCE
  :: start_owed ->
#else
  :: start_owed && open && !(entries != begun && WHAT_RUNS == ANYWHERE) && !IS_ELSEWHERE && doubt != UNSETTLED && j == 0 ->
#endif
    must(STARTS, !IS_ELSEWHERE && doubt != UNSETTLED && j == 0);
    start_owed = 0;
    runs = WHAT_RUNS == SOMEWHERE
  :: else -> skip
  fi
#ifdef A_START_THAT_HAS_TO_WAIT_IS_FORGOTTEN
  ;
  start_owed = 0
#endif
}

/* The number of facts that wait, in `j`. */
inline count_facts() {
  i = 0;
  j = 0;
  do
  :: i < waiting -> j = j + HAS_HAPPENED(line[i]); i++
  :: else -> break
  od
}

/* ---- for trails and for the comparison with the real core ---- */

#define TELL_PENDING(one) printf(" [%d %d %d %d %d %d %d %d %d %d]", one.id, one.kind, one.what, one.source, one.visit, \
  one.from, one.own, one.attempts, one.acted, one.later)

inline tell_state() {
  printf("= %d %d %d %d %d %d %d %d", open, device_at, system_at, pair, over, armed, stepped, owed + 2 * start_owed);
  printf(" doubt %d %d %d %d", (doubt_plan != 0 -> (doubt == SETTLED -> REPORTED : REMEMBERING) : doubt), doubt_id, doubt_steps, doubt_facts);
  printf(" work %d %d %d %d %d %d", busy, decided, plan, stage, taken, facts);
  TELL_PENDING(work);
  k = 0;
  do
  :: k < waiting -> TELL_PENDING(line[k]); k++
  :: else -> break
  od;
  printf("\n")
}
