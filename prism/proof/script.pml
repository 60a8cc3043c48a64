/* The core alone, with the inputs of a script: study/proof/conformance.py adds the script and compares the output. */

#include "tables.pml"

byte counted;
#define COUNTED

inline must(property, holds) { skip }

#include "core.pml"
#include "inputs.pml"
#include "turn.pml"

/* A new core. */
inline anew() {
  end_work();
  no_doubt();
  do
  :: waiting > 0 -> take_out(0)
  :: else -> break
  od;
  counted = 0;
  pair = 0;
  open = 0;
  device_at = INITIAL_DEVICE;
  system_at = INITIAL_SYSTEM;
  stepped = 0;
  owed = 0;
  over = 1;
  armed = 0;
  start_owed = 0;
  runs = 0
}

mtype = { OPENED, CLOSING, CLOSED, RECOVERED, HEARD_OF, ASKED_OF, FOUND_AT, TIMER_DUE, READY_FOR, PLANNED, DISMISSED, SENDING_IT,
  WAS_SENT, FAILED, GIVEN_UP, LOCATED, CHANGED, EVOLVED_TO, ANEW, PLANNED_IN };

chan told = [0] of { mtype, int, int, int, int };

init {
  mtype input;
  int a, b, c, d;
#define FILLING
  d_step {
#include "tables.pml"
    skip
  };
  run Script();
end:
  do
  :: told?input,a,b,c,d ->
    d_step {
      observed_count = 0;
      ended_count = 0;
      may_part = 0;
      entries = 0;
      /* Without a number it is the occurrence in progress. */
      a = (a == 0 && (input == SENDING_IT || input == FAILED || input == GIVEN_UP || input == LOCATED) -> work.id : a);
      if
      :: input == OPENED -> opened()
      :: input == CLOSING -> closing()
      :: input == CLOSED -> closed()
      :: input == RECOVERED -> recovered()
      :: input == HEARD_OF -> observed_heard(a, b, c, d)
      :: input == ASKED_OF -> observed_asked(a, b)
      :: input == FOUND_AT -> observed_found(a, b)
      :: input == TIMER_DUE -> timer_due(PRESENT + a)
      :: input == READY_FOR -> ready()
      :: input == PLANNED -> planned(a, b, c, d)
      :: input == DISMISSED -> dismissed(a)
      :: input == SENDING_IT -> sending(a)
      :: input == WAS_SENT -> sent(a, b)
      :: input == FAILED -> failed(a)
      :: input == GIVEN_UP -> given_up(a)
      :: input == LOCATED -> located(a, b)
      :: input == CHANGED -> changed()
      :: input == EVOLVED_TO -> evolved()
      :: input == ANEW -> anew()
      :: input == PLANNED_IN ->
        code = 0;
        if
        :: busy && !decided && device_at == a && system_at == b -> decide()
        :: else -> skip
        fi;
        planned(work.id, code, a, b)
      fi;
      tell_state()
    }
  od
}
