/*
 * The inputs of the core, see org.evoloop.engine.Inputs. Each is one atomic step (TELL). To remove a mechanism, define its
 * name, which is that of a Mutation in the core's own tests, or of one in docs/proof.md.
 */

inline opened() {
  begun = entries;
  open = 1;
  ask_where();
  if
  :: busy && stage == INTERRUPTED && decided && LEAVES(plan) -> skip
  :: else ->
    if
    :: !over -> leave(); enter_as_left()
    :: else -> enter()
    fi;
    start_function()
  fi
}

inline closing() {
  if
  :: open ->
    open = 0;
    if
    :: busy && stage == INTERRUPTED && !HAS_HAPPENED(work) && NEXT_STEP != NONE -> conclude(true)
    :: else -> skip
    fi;
    k = 0;
    do
    :: k < waiting ->
#ifdef CLOSING_DISCARDS_FACTS
      take_out(k)
#else
      if
      :: HAS_HAPPENED(line[k]) -> k++
      :: else -> take_out(k); not_heard()
      fi
#endif
    :: else -> break
    od
  :: else -> skip
  fi
}

inline closed() { leave() }

/* The process has ended, and another one has recovered the journal's contents. */
inline recovered() {
  open = 0;
#ifdef A_STEP_IS_WRITTEN_DOWN_AFTER_IT_WAS_SENT
  stage = (stage == SENDING -> READY : stage);
#endif
  if
  :: busy && stage == SENDING ->
    abandon();
#ifdef AN_END_LEAVES_NO_DOUBT
    no_doubt();
#endif
    start_function()
  :: busy && stage != SENDING && !decided ->
    COPY(next_one, work);
    end_work();
    put_back()
  :: busy && stage != SENDING && decided ->
#ifdef AN_END_FORGETS_WHAT_IS_IN_PROGRESS
    end_work()
#else
#ifdef AN_INTERRUPTED_PLAN_IS_MADE_ANEW
    decided = 0;
    plan = 0;
    taken = 0;
    stage = READY;
    directive = NOTHING;
    forget_facts()
#else
    stage = INTERRUPTED;
    directive = NOTHING;
    forget_facts()
#endif
#endif
  :: else -> skip
  fi
#ifdef AN_END_FORGETS_WHAT_WAITS
  ;
  do
  :: waiting > 0 -> take_out(0)
  :: else -> break
  od
#endif
}

/* ---- occurrences ---- */

inline observed_heard(event, source_, visit_, acted_) {
  make(HEARD, event, source_, visit_, acted_);
  if
  :: !knows_table[IX(pair, 0, 0, next_one.what)] && (open || next_one.acted) -> end_unheard()
  :: (knows_table[IX(pair, 0, 0, next_one.what)] || !(open || next_one.acted)) &&
     (next_one.acted || (is_own_table[next_one.what] && next_one.source != BUTTON)) -> follow_device()
  :: knows_table[IX(pair, 0, 0, next_one.what)] && !next_one.acted && is_own_table[next_one.what] &&
     next_one.source == BUTTON ->
    if
    :: open -> end_unheard()
    :: else -> not_taken()
    fi
  :: else -> asked_for()
  fi
}

inline observed_asked(event, visit_) {
  make(ASKED, event, FUNCTION, visit_, 0);
  asked_for()
}

inline asked_for() {
  if
  :: open -> enqueue(NONE, NONE)
  :: else -> not_taken()
  fi
}

/* The occurrence was observed, and is refused. */
inline not_taken() {
  observe();
  not_heard()
}

/* Arrivals.endAtOnce */
inline end_unheard() {
  observe();
  ended()
}

inline observe() {
  observed_count++;
#ifdef COUNTED
  counted++;
#endif
  printf("new 0\n")
}

/* Arrivals.follow */
inline follow_device() {
#ifdef A_CLOSED_CONVERTER_HEARS_NO_FACTS
  if
  :: !open -> skip
  :: else ->
#endif
  at_state = device_at;
  target = OWN(device_at, next_one.what);
  happens_meanwhile(next_one.what);
#ifndef FACTS_WAIT_FOR_THEIR_TURN
  device_at = (target != NONE -> target : device_at);
#endif
  code = next_one.what;
  possible = !(IS_IMPOSSIBLE(at_state, code) && !(busy && stage == SENDING));
  enqueue(at_state, target);
  if
  :: !possible ->
    device_at = (only_table[code] != NONE -> only_table[code] : device_at);
    contradicted()
  :: else -> skip
  fi
#ifdef A_CLOSED_CONVERTER_HEARS_NO_FACTS
  fi
#endif
}

/* `late`: it was found before the last step was sent. */
inline observed_found(state, late) {
#if ONLY == ANOTHER
  hears();
#endif
  if
  :: late && stepped -> end_unheard()
  :: else ->
    was_in_doubt = doubt == UNSETTLED;
    completes = was_in_doubt && COMPLETES(state);
    noted_plan = doubt_plan;
    happens_meanwhile(FOUND_IN + (state));
    settle_doubt();
    if
    :: completes -> doubt_plan = noted_plan; doubt_system = system_at
    :: else -> skip
    fi;
    if
    :: completes || (state) != device_at ->
      at_state = device_at;
      make(FOUND, state, DEVICE, ANY, 0);
#ifndef FACTS_WAIT_FOR_THEIR_TURN
      device_at = next_one.what;
#endif
      enqueue(at_state, NONE)
    :: !completes && (state) == device_at && was_in_doubt -> follow_if_apart()
    :: else -> skip
    fi;
    begun = entries;
    start_function()
  fi
#if ONLY == ANOTHER
  ; heard()
#endif
}

inline timer_due(visit_) {
  if
  :: open && (visit_) == PRESENT && !over && armed ->
    observed_heard(timer_table[IX(pair, 0, system_at, 0)], TIMER, PRESENT, 0)
  :: else -> skip
  fi
}
