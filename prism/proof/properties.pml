/* Monitors of the properties. */

byte violated;
hidden byte held_before;
hidden byte was_entered;

/* Steps of an interrupted plan: those that had begun must not begin again. */
byte lost;
hidden byte remembered;
bit lost_flying;
int lost_plan;
byte lost_taken;
byte lost_attempts;

/*
 * Whether device and new model were left in states that do not go together by what failed or by what a function had the device
 * do, before or after a swap. That no longer counts once the new model has to follow the device.
 */
bit may_be_apart;

/* The number of visits so far: none, one, more. */
byte visited;

/* With ONLY, only that property is checked. */
#ifndef ONLY
#define ONLY 0
#endif

inline must(property, holds) {
  if
  :: (holds) || violated || (ONLY && ONLY != property) -> skip
  :: else -> violated = property
  fi
}

/* These compare what is so before and after an input; a search for one property has them only if it is for theirs. */
#if ONLY == RESUMES
hidden int awaited;

/* Before a report, or a question that a report has answered, is decided. */
inline awaits() {
  awaited = ((work.kind == FOUND || work.kind == IN_DOUBT) && IS_REPORTED && COMPLETES(device_at) -> doubt_plan : 0)
}

inline came() {
  must(RESUMES, awaited == 0 || doubt_plan != 0 || doubt == UNSETTLED || system_at == AFTER(awaited))
}
#endif
#if ONLY == ANOTHER
hidden byte owed_before, facts_before;

/* Before the device says where it is. */
inline hears() {
  count_facts();
  owed_before = owed;
  facts_before = j
}

inline heard() {
  must(ANOTHER, owed_before || facts_before > 0 || !owed || doubt != SETTLED || !HOLDS(doubt_id))
}
#endif

#define WHEN(guard, ...) d_step { (guard) -> before(); __VA_ARGS__; after() }

inline before() {
  held_before = waiting + busy;
  observed_count = 0;
  ended_count = 0;
  may_part = 0;
  entries = 0
}

inline after() {
  visited = (entries + visited > 2 -> 2 : entries + visited);
  entries = 0;
  must(ONCE, held_before + observed_count == waiting + busy + ended_count);
#ifdef PAPER
  must(RECORD, busy || flight || untold > 0 || device_at == device);
#else
  must(RECORD, untold > 0 || doubt == UNSETTLED || device_at == device);
#endif
  must(STUCK, !(open && waiting == 0 && !busy && over && !owed));
  may_be_apart = ((may_be_apart && !owed) || may_part) && !STANDS_TOGETHER(device_at, system_at);
  must(TOGETHER, !open || waiting > 0 || busy || owed || doubt == UNSETTLED || STANDS_TOGETHER(device_at, system_at) || may_be_apart);
  must(NEEDED, !open || waiting > 0 || busy || owed || doubt == UNSETTLED || !IS_ELSEWHERE);
  must(RUNS, !open || waiting > 0 || busy || owed || doubt == UNSETTLED || WHAT_RUNS != SOMEWHERE || runs);
  tell_state();
  tell_violation();
  assert(violated == 0)
}

inline remember_plan() {
  remembered = busy && decided;
  if
  :: remembered ->
    lost = work.id;
    lost_flying = stage == SENDING;
    lost_plan = plan;
    lost_taken = taken;
    lost_attempts = work.attempts
  :: else -> skip
  fi
}

/* The progress of a plan survives the end of a process. */
inline nothing_lost() {
  must(AGAIN, !remembered || lost_flying || (busy && work.id == lost && plan == lost_plan && taken == lost_taken))
}

inline nothing_again() {
  must(AGAIN, work.id != lost || work.attempts > lost_attempts || (!lost_flying && plan == lost_plan && taken >= lost_taken))
}

inline tell_violation() {
  printf("device %d\n", device);
  if
  :: violated -> printf("violated %d\n", violated)
  :: else -> skip
  fi
}
