/* The inputs of the core that concern the occurrence in progress, and changes; see inputs.pml. */

/* ---- a turn ---- */

inline ready() {
  if
  :: open && busy && stage == INTERRUPTED -> stage = RESUMED; forget_facts()
  :: else -> skip
  fi;
  do
  :: !busy && open && (waiting > 0 || owed) ->
    count_facts();
    if
    :: owed && j == 0 -> find_owed()
    :: else -> give_turn()
    fi
  :: else -> break
  od
}

/* Arrivals.owedFinding: the new model follows to the device's state if it is not where it goes together with that. */
inline find_owed() {
  owed = 0;
  make(FOUND, device_at, DEVICE, ANY, 0);
  give_number();
  next_one.id = number;
  next_one.from = device_at;
  COPY(work, next_one);
  busy = 1
}

/* Line.next: the place of the first fact, else of what is urgent, else of the first occurrence, in `place`. */
inline find_next() {
  place = 0;
#ifndef FACTS_WAIT_BEHIND_REQUESTS
  do
  :: place < waiting && !HAS_HAPPENED(line[place]) -> place++
  :: else -> break
  od;
  place = (place < waiting -> place : 0)
#endif
#if defined(HAS_URGENT) && !defined(WHAT_IS_URGENT_WAITS_FOR_ITS_TURN)
  ;
  u = 0;
  do
  :: u < waiting && !IS_URGENT(line[u]) -> u++
  :: else -> break
  od;
  place = (u < waiting && !HAS_HAPPENED(line[place]) -> u : place)
#endif
}

inline give_turn() {
  find_next();
  if
#ifndef VISITS_ARE_NOT_TOLD_APART
  :: line[place].visit == FORMER -> end_at_once()
#endif
  :: line[place].kind == IN_DOUBT && doubt != UNSETTLED -> end_at_once()
  :: else ->
    if
    :: line[place].kind == HEARD && line[place].source == TIMER && line[place].what == timer_table[IX(pair, 0, system_at, 0)] -> armed = 0
    :: else -> skip
    fi;
    COPY(work, line[place]);
    take_out(place);
    busy = 1;
    count_facts();
    must(HEARD_FIRST, HAS_HAPPENED(work) || j == 0);
#ifdef HAS_URGENT
    see_urgent();
    must(URGENT, HAS_HAPPENED(work) || first_urgent == waiting || (IS_URGENT(work) && first_urgent >= place));
#endif
    must(VISIT, work.visit != FORMER);
    must(QUESTION, doubt != UNSETTLED || work.kind == IN_DOUBT || !(line[0].kind == IN_DOUBT || line[1].kind == IN_DOUBT))
  fi
}

/* It may be what the end of the present visit has waited for. */
inline end_at_once() {
  begun = entries;
  ended_kind = line[place].kind;
  take_out(place);
  ended();
  enter_again(ended_kind);
  start_function()
}

inline end_work() {
  busy = 0;
  decided = 0;
  plan = 0;
  late = 0;
  taken = 0;
  step_source = 0;
  stage = READY;
  directive = NOTHING;
  CLEAR(work);
  forget_facts()
}

inline forget_facts() {
  facts = 0;
  i = 0;
  do
  :: i < FACTS -> fact[i] = 0; i++
  :: else -> break
  od
}

inline keep_facts() {
  k = facts;
  i = 0;
  do
  :: i < FACTS -> kept_fact[i] = fact[i]; i++
  :: else -> break
  od
}

inline keep_doubts_facts() {
  k = doubt_facts;
  i = 0;
  do
  :: i < FACTS -> kept_fact[i] = doubt_fact[i]; i++
  :: else -> break
  od
}

/* Notes the step in transit, which is needed after the work has ended. */
inline note_step() {
  noted_id = work.id;
  noted_event = NEXT_STEP;
  noted_source = step_source;
  noted_system = system_at;
  noted_plan = (KIND(plan) == NEW -> plan : 0)
}

/* A plan that was made when the device was in `start` and the system in `system`. */
inline planned(id_, plan_, start, system) {
  if
  :: busy && work.id == (id_) && stage == RESUMED -> stage = READY; forget_facts(); go_on()
  :: busy && work.id == (id_) && stage != RESUMED && !decided ->
    count_facts();
#ifdef HAS_URGENT
    see_urgent();
#endif
    if
    :: device_at != (start) || system_at != (system) -> again()
#ifndef A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_FACTS
    :: device_at == (start) && system_at == (system) && !HAS_HAPPENED(work) && (j > 0 || (owed && IS_ELSEWHERE)) -> give_way()
#endif
#if defined(HAS_URGENT) && !defined(A_REQUEST_THAT_HAS_BEGUN_IS_DECIDED_BEFORE_WHAT_IS_URGENT)
    :: device_at == (start) && system_at == (system) && !HAS_HAPPENED(work) && !(j > 0 || (owed && IS_ELSEWHERE)) && IS_OVERTAKEN -> give_way()
#endif
    :: else ->
      must(HEARD_FIRST, HAS_HAPPENED(work) || j == 0);
#ifdef HAS_URGENT
      must(URGENT, HAS_HAPPENED(work) || !IS_OVERTAKEN);
#endif
#ifdef A_NEW_STATE_SENDS_NOTHING
      plan = (KIND(plan_) == NEW -> WITHOUT_STEPS(plan_) : plan_);
#else
      plan = plan_;
#endif
#if ONLY == RESUMES
      awaits();
#endif
      completes_by_report();
      decided = 1;
      late = work.later;
      taken = 0;
      stage = READY;
      step_source = device_at;
      forget_facts();
      if
      :: LEAVES(plan) -> leave()
      :: else -> skip
      fi;
      go_on()
#if ONLY == RESUMES
      ; came()
#endif
    fi
  :: else -> skip
  fi
}

/* Conversion.reported: a report of the device's state may complete what was interrupted, as its answer does. */
inline completes_by_report() {
  if
#ifdef A_QUESTION_FORGETS_WHAT_A_REPORT_COMPLETES
  :: IS_REPORTED ->
#else
  :: IS_REPORTED && work.kind != IN_DOUBT ->
#endif
    if
#ifndef A_DOUBT_FORGETS_ITS_DECISION
    :: work.kind == FOUND && KIND(plan) == RESYNCHRONIZATION && COMPLETES(device_at) -> plan = WITHOUT_STEPS(doubt_plan)
#endif
    :: else -> skip
    fi;
    forget_plan()
  :: else -> skip
  fi
}

inline dismissed(id_) {
  if
  :: busy && work.id == (id_) -> conclude(true)
  :: else -> skip
  fi
}

inline go_on() {
  if
  :: KIND(plan) == INQUIRY -> directive = LOCATE
#ifdef NOBODY_IS_ASKED_TO_GO_ON
  :: KIND(plan) != INQUIRY && NEXT_STEP != NONE -> directive = NOTHING
#else
  :: KIND(plan) != INQUIRY && NEXT_STEP != NONE -> directive = SEND
#endif
  :: else -> arrive()
  fi
}

inline sending(id_) {
#ifdef HAS_URGENT
  see_urgent();
#ifndef A_PLAN_GOES_ON_WHILE_WHAT_IS_URGENT_WAITS
  if
  :: work.id == (id_) && stage != SENDING && decided && NEXT_STEP != NONE && IS_OVERTAKEN -> conclude(true)
  :: else -> skip
  fi;
#endif
#endif
  if
  :: busy && work.id == (id_) && stage != SENDING && decided && NEXT_STEP != NONE ->
    if
#ifdef AN_OVERTAKEN_STEP_IS_SENT_ALL_THE_SAME
    :: true ->
#else
    :: step_source == device_at && !(waiting > 0 && line[0].kind == IN_DOUBT) ->
#endif
#ifdef HAS_URGENT
      must(URGENT, !IS_OVERTAKEN);
#endif
      stage = SENDING;
      forget_facts()
#ifndef AN_OVERTAKEN_STEP_IS_SENT_ALL_THE_SAME
    :: else -> again()
#endif
    fi
  :: else -> skip
  fi
}

/* The step that was being sent has taken effect. */
inline sent(id_, in_order) {
  if
  :: busy && work.id == (id_) && stage == SENDING -> took(in_order)
  :: else -> took_late(id_, in_order)
  fi
}

inline took(in_order) {
  keep_facts();
  note_step();
  target = OWN(step_source, NEXT_STEP);
  sure = 1;
  if
  :: k > 0 ->
    takes(device_at, NEXT_STEP);
    if
    :: in_order -> skip
    :: else -> always_ends_in(target, NEXT_STEP, step_source)
    fi
  :: else -> skip
  fi;
  as_planned = sure && target == OWN(step_source, NEXT_STEP);
  step_source = OWN(step_source, NEXT_STEP);
  step_counts();
  device_at = target;
  taken++;
  stage = READY;
  forget_facts();
  if
  :: as_planned -> go_on()
  :: else -> again()
  fi;
  if
  :: sure ->
    can_have_happened(noted_source, noted_event, in_order);
    if
    :: possible -> skip
    :: else -> contradicted()
    fi
  :: else ->
    noted_plan = 0;
    doubt_step(noted_id, noted_event, noted_source)
#ifdef THE_ORDER_IS_NEVER_IN_DOUBT
    ; no_doubt()
#endif
  fi
}

/* A step was sent: all earlier observations are older. */
inline step_counts() {
  stepped = 1;
  work.later = busy;
  i = 0;
  do
  :: i < waiting -> line[i].later = 1; i++
  :: else -> break
  od;
  doubt_steps = (doubt && doubt_steps == SAME -> LATER : doubt_steps)
}

inline took_late(id_, in_order) {
  if
  :: doubt ->
    takes(device_at, doubt_event);
    keep_doubts_facts();
    always_ends_in(target, doubt_event, doubt_source);
    if
    :: doubt_event != NONE && doubt_id == (id_) && (in_order -> (doubt == SETTLED || doubt_steps == SAME)
                                      : (doubt_steps == SAME && !(busy && stage == SENDING) && sure)) ->
      settle_doubt();
      if
      :: doubt_steps != NEVER_KNOWN -> no_doubt()
      :: else -> skip
      fi;
      step_counts();
      device_at = target;
#ifndef A_LATE_EFFECT_MOVES_THE_DEVICE_ONLY
      owed = 1;
#endif
      if
      :: busy && stage == SENDING -> add_fact(FOUND_IN + target)
      :: else -> skip
      fi
    :: else ->
      if
      :: doubt == SETTLED -> doubt = UNSETTLED; forget_plan(); ask_where()
      :: else -> skip
      fi
    fi
  :: else -> skip
  fi
}

/* ---- ends ---- */

inline arrive() {
  begun = entries;
  system_at = AFTER(plan);
  must(REACHED, KIND(plan) != NEW || work.from != NONE || !IS_ELSEWHERE);
  owed = owed || (work.from != NONE && late && !STANDS_TOGETHER(device_at, system_at));
  ended_kind = work.kind;
  flag = KIND(plan) == IMPOSSIBLE && HAS_TRANSITION(plan);
  leaves = LEAVES(plan);
  may_part = may_part || KIND(plan) == IMPOSSIBLE || work.kind == ASKED;
  end_work();
  if
  :: leaves -> enter()
  :: else -> skip
  fi;
  ended();
  if
  :: flag -> leave()
  :: else -> skip
  fi;
  enter_again(ended_kind);
  start_function()
}

inline conclude(fails) {
  end_with(fails);
  start_function()
}

inline end_with(fails) {
  begun = entries;
  ended_kind = work.kind;
  may_part = may_part || fails;
  end_work();
  ended();
  enter_again(ended_kind)
}

/* The occurrence in progress is given up while its step is being sent, which may still have its effect. */
inline abandon() {
  keep_facts();
  note_step();
  end_with(true);
  doubt_step(noted_id, noted_event, noted_source)
}

/* The plan has been overtaken: the occurrence is decided again, before all others. */
inline again() {
  if
  :: work.attempts + 1 > MOST_ATTEMPTS || (!open && !HAS_HAPPENED(work)) -> conclude(true)
  :: else ->
    COPY(next_one, work);
    next_one.attempts++;
    end_work();
    put_back()
  fi
}

/* What the device did by itself is heard first, and then what is urgent. */
inline give_way() {
  if
  :: !open -> conclude(true)
  :: else ->
    COPY(next_one, work);
    end_work();
    put_back()
  fi
}

/* The occurrence in progress fails. After a fact that was not decided, the new model follows the device. */
inline break_off() {
  if
  :: !decided && work.from != NONE ->
#ifdef A_FACT_THAT_FAILS_MOVES_THE_DEVICE_ONLY
    conclude(false)
#else
    find(device_at);
    if
    :: LEAVES(code) -> leave()
    :: else -> skip
    fi;
    plan = code;
    decided = 1;
    arrive()
#endif
  :: else -> conclude(true)
  fi
}

inline failed(id_) {
  if
#ifdef A_STATE_IS_NOT_ENTERED_AGAIN
  :: busy && work.id == (id_) -> end_work(); ended()
#else
  :: busy && work.id == (id_) ->
    was_sending = stage == SENDING;
    keep_facts();
    note_step();
    break_off();
    if
    :: was_sending ->
      can_have_happened(noted_source, NONE, true);
      if
      :: possible -> skip
      :: else -> contradicted()
      fi
    :: else -> skip
    fi
#endif
  :: else -> skip
  fi
}

inline given_up(id_) {
  if
  :: busy && work.id == (id_) && stage == SENDING ->
    abandon();
#ifdef GIVING_UP_LEAVES_NO_DOUBT
    no_doubt();
#endif
    start_function()
  :: busy && work.id == (id_) && stage != SENDING -> break_off()
  :: else -> skip
  fi
}

#ifdef A_DOUBT_FORGETS_ITS_DECISION
#define DOES_NOT_COMPLETE true
#else
#define DOES_NOT_COMPLETE (!completes)
#endif

/* The transition is taken after all, and nothing is sent. */
inline complete(state) {
  device_at = state;
  count_facts();
  owed = owed || j > 0;
  if
  :: LEAVES(noted_plan) -> leave()
  :: else -> skip
  fi;
  plan = WITHOUT_STEPS(noted_plan);
  decided = 1;
  arrive()
}

/* The result of a query of the device's state; `state` is NONE if it is unknown. */
inline located(id_, state) {
#if ONLY == ANOTHER
  hears();
#endif
#ifdef AN_ANSWER_COUNTS_HOWEVER_OLD_IT_IS
  forget_facts();
#endif
  if
  :: !(busy && work.id == (id_)) -> skip
  :: busy && work.id == (id_) ->
    if
    :: doubt == UNSETTLED && facts > 0 && work.attempts < MOST_ATTEMPTS ->
      work.attempts++;
      forget_facts();
      directive = LOCATE
    :: doubt != UNSETTLED || (facts > 0 && work.attempts >= MOST_ATTEMPTS) || (facts == 0 && (state) == NONE) -> conclude(false)
    :: else ->
      noted_plan = doubt_plan;
      completes = COMPLETES(state);
      happens_meanwhile(FOUND_IN + (state));
      settle_doubt();
      if
#ifndef A_DOUBT_FORGETS_ITS_DECISION
      :: completes -> complete(state)
#endif
      :: DOES_NOT_COMPLETE && (state) == device_at -> follow_if_apart(); conclude(false)
      :: DOES_NOT_COMPLETE && (state) != device_at ->
        find(state);
        if
        :: LEAVES(code) -> leave()
        :: else -> skip
        fi;
        device_at = state;
#ifndef AN_ANSWER_MOVES_THE_DEVICE_ONLY
        count_facts();
        owed = owed || j > 0;
#endif
        plan = code;
        decided = 1;
        arrive()
      fi;
      must(RESUMES, !completes || system_at == AFTER(noted_plan))
    fi
  fi
#if ONLY == ANOTHER
  ; heard()
#endif
}

/* ---- changes ---- */

inline changed() { ask_where() }

#define FATE fate_table[IX(pair, device_at, system_at, 0)]
#define POSSIBLE(f) ((f) & 1)
#define FOLLOWS(f) (((f) >> 8) & 1)
#define FATE_SYSTEM(f) (((f) >> 1) & 15)
#define FATE_SENDS(f) (((f) >> 5) & 1)
#define KEEPS_TIMER(f) (((f) >> 6) & 1)
#define KEEPS_FUNCTION(f) (((f) >> 7) & 1)

/* Whether other models can take over; see Core.hindrance. */
#define UNHINDERED (!busy && !RETRY_WAITS && doubt != UNSETTLED && !IS_REPORTED && POSSIBLE(FATE))

inline evolved() {
  if
  :: UNHINDERED ->
    code = FATE;
    timer = timer_table[IX(pair, 0, system_at, 0)];
    goes_on = over || !open || (!FATE_SENDS(code) && KEEPS_FUNCTION(code));
    may_part = !FATE_SENDS(code) && !STANDS_TOGETHER(device_at, system_at);
    pair = 1 - pair;
#ifdef OTHER_MODELS_BEGIN_WHERE_THEY_WOULD_INITIALLY
    system_at = INITIAL_SYSTEM;
    device_at = INITIAL_DEVICE;
#else
    system_at = FATE_SYSTEM(code);
#endif
#ifndef A_SWAP_LEAVES_THE_STATES_APART
    owed = owed || FOLLOWS(code);
#endif
    k = 0;
    do
    :: k < waiting ->
#ifdef OTHER_MODELS_FORGET_WHAT_WAITS
      take_out(k)
#else
      if
      :: line[k].visit == PRESENT &&
         (line[k].kind == HEARD && line[k].source == TIMER
            -> !(line[k].what == timer && KEEPS_TIMER(code)) : !goes_on) -> ended(); take_out(k)
      :: else -> k++
      fi
#endif
    :: else -> break
    od;
    if
    :: goes_on -> skip
    :: else -> leave()
    fi;
    armed = (KEEPS_TIMER(code) -> armed : timer_table[IX(pair, 0, system_at, 0)] != NONE);
    if
    :: !goes_on && !FATE_SENDS(code) -> begun = entries; enter_as_left(); start_function()
    :: else -> skip
    fi;
    if
    :: FATE_SENDS(code) ->
      make(EVOLVED, NONE, DEVICE, ANY, 0);
      give_number();
      next_one.id = number;
      prepend()
    :: else -> skip
    fi
  :: else -> skip
  fi
}
