/* Included twice: first declarations, then, with FILLING, the statements that fill the tables. */
#ifndef FILLING
//@ device 1 off
//@ device 2 on
//@ system 1 off
//@ system 2 on
//@ system 3 wait
//@ system 4 incandescentOn
//@ event 1 switch
//@ event 2 timeout
#define EVENTS1 3
#define SYSTEM1 5
#define DEVICE1 3
#define INITIAL_DEVICE 1
#define INITIAL_SYSTEM 1
#define CAPACITY 2
#define IX(p, d, s, e) ((((p) * DEVICE1 + (d)) * SYSTEM1 + (s)) * EVENTS1 + (e))
#define OWN(d, e) own_table[(d) * EVENTS1 + (e)]
hidden int asked_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int acted_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int react_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int ask_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int settle_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int find_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int timer_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int fate_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int knows_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int function_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden int elsewhere_table[2 * DEVICE1 * SYSTEM1 * EVENTS1];
hidden byte own_table[DEVICE1 * EVENTS1];
hidden byte is_own_table[EVENTS1];
hidden byte has_table[EVENTS1];
hidden byte only_table[EVENTS1];
inline choose_button() {
  if
  :: event = 1
  fi
}
inline choose_asked() {
  if
  :: event = 1
  fi
}
inline choose_raised() {
  if
  :: event = 2
  fi
}
inline choose_device_state() {
  if
  :: event = 1
  :: event = 2
  fi
}
inline choose_own() {
  if
  :: OWN(device, 1) != 0 -> event = 1
  fi
}
#define CAN_ACT (OWN(device, 1) != 0)
#else
has_table[1] = 1;
own_table[1 * EVENTS1 + 1] = 2;
own_table[2 * EVENTS1 + 1] = 1;
knows_table[IX(0, 0, 0, 1)] = 1;
knows_table[IX(0, 0, 0, 2)] = 1;
find_table[IX(0, 1, 1, 0)] = 1;
settle_table[IX(0, 1, 1, 0)] = 20;
fate_table[IX(0, 1, 1, 0)] = 131;
asked_table[IX(0, 1, 1, 1)] = 16777513;
acted_table[IX(0, 1, 1, 1)] = 16777257;
react_table[IX(0, 1, 1, 1)] = 16777513;
ask_table[IX(0, 1, 1, 1)] = 19;
asked_table[IX(0, 1, 1, 2)] = 16;
acted_table[IX(0, 1, 1, 2)] = 16;
react_table[IX(0, 1, 1, 2)] = 16;
ask_table[IX(0, 1, 1, 2)] = 19;
find_table[IX(0, 2, 1, 0)] = 2;
settle_table[IX(0, 2, 1, 0)] = 276;
fate_table[IX(0, 2, 1, 0)] = 131;
asked_table[IX(0, 2, 1, 1)] = 16777257;
acted_table[IX(0, 2, 1, 1)] = 16777513;
react_table[IX(0, 2, 1, 1)] = 16777257;
ask_table[IX(0, 2, 1, 1)] = 19;
asked_table[IX(0, 2, 1, 2)] = 16;
acted_table[IX(0, 2, 1, 2)] = 16;
react_table[IX(0, 2, 1, 2)] = 16;
ask_table[IX(0, 2, 1, 2)] = 19;
find_table[IX(0, 1, 2, 0)] = 1;
settle_table[IX(0, 1, 2, 0)] = 292;
fate_table[IX(0, 1, 2, 0)] = 133;
asked_table[IX(0, 1, 2, 1)] = 16777274;
acted_table[IX(0, 1, 2, 1)] = 16777274;
react_table[IX(0, 1, 2, 1)] = 16777274;
ask_table[IX(0, 1, 2, 1)] = 35;
asked_table[IX(0, 1, 2, 2)] = 32;
acted_table[IX(0, 1, 2, 2)] = 32;
react_table[IX(0, 1, 2, 2)] = 32;
ask_table[IX(0, 1, 2, 2)] = 35;
find_table[IX(0, 2, 2, 0)] = 2;
settle_table[IX(0, 2, 2, 0)] = 36;
fate_table[IX(0, 2, 2, 0)] = 133;
asked_table[IX(0, 2, 2, 1)] = 16777274;
acted_table[IX(0, 2, 2, 1)] = 16777274;
react_table[IX(0, 2, 2, 1)] = 16777274;
ask_table[IX(0, 2, 2, 1)] = 35;
asked_table[IX(0, 2, 2, 2)] = 32;
acted_table[IX(0, 2, 2, 2)] = 32;
react_table[IX(0, 2, 2, 2)] = 32;
ask_table[IX(0, 2, 2, 2)] = 35;
timer_table[IX(0, 0, 3, 0)] = 2;
function_table[IX(0, 0, 3, 0)] = 1;
find_table[IX(0, 1, 3, 0)] = 3;
settle_table[IX(0, 1, 3, 0)] = 308;
fate_table[IX(0, 1, 3, 0)] = 261;
asked_table[IX(0, 1, 3, 1)] = 16777290;
acted_table[IX(0, 1, 3, 1)] = 16777290;
react_table[IX(0, 1, 3, 1)] = 16777290;
ask_table[IX(0, 1, 3, 1)] = 51;
asked_table[IX(0, 1, 3, 2)] = 16777241;
acted_table[IX(0, 1, 3, 2)] = 16777241;
react_table[IX(0, 1, 3, 2)] = 16777241;
ask_table[IX(0, 1, 3, 2)] = 51;
find_table[IX(0, 2, 3, 0)] = 3;
settle_table[IX(0, 2, 3, 0)] = 52;
fate_table[IX(0, 2, 3, 0)] = 5;
asked_table[IX(0, 2, 3, 1)] = 16777290;
acted_table[IX(0, 2, 3, 1)] = 16777290;
react_table[IX(0, 2, 3, 1)] = 16777290;
ask_table[IX(0, 2, 3, 1)] = 51;
asked_table[IX(0, 2, 3, 2)] = 16777497;
acted_table[IX(0, 2, 3, 2)] = 16777497;
react_table[IX(0, 2, 3, 2)] = 16777497;
ask_table[IX(0, 2, 3, 2)] = 51;
function_table[IX(0, 0, 4, 0)] = 1;
find_table[IX(0, 1, 4, 0)] = 4;
settle_table[IX(0, 1, 4, 0)] = 324;
fate_table[IX(0, 1, 4, 0)] = 3;
asked_table[IX(0, 1, 4, 1)] = 16777241;
acted_table[IX(0, 1, 4, 1)] = 16777497;
react_table[IX(0, 1, 4, 1)] = 16777241;
ask_table[IX(0, 1, 4, 1)] = 67;
asked_table[IX(0, 1, 4, 2)] = 64;
acted_table[IX(0, 1, 4, 2)] = 64;
react_table[IX(0, 1, 4, 2)] = 64;
ask_table[IX(0, 1, 4, 2)] = 67;
find_table[IX(0, 2, 4, 0)] = 4;
settle_table[IX(0, 2, 4, 0)] = 68;
fate_table[IX(0, 2, 4, 0)] = 35;
asked_table[IX(0, 2, 4, 1)] = 16777497;
acted_table[IX(0, 2, 4, 1)] = 16777241;
react_table[IX(0, 2, 4, 1)] = 16777497;
ask_table[IX(0, 2, 4, 1)] = 67;
asked_table[IX(0, 2, 4, 2)] = 64;
acted_table[IX(0, 2, 4, 2)] = 64;
react_table[IX(0, 2, 4, 2)] = 64;
ask_table[IX(0, 2, 4, 2)] = 67;
knows_table[IX(1, 0, 0, 1)] = 1;
find_table[IX(1, 1, 1, 0)] = 1;
settle_table[IX(1, 1, 1, 0)] = 20;
fate_table[IX(1, 1, 1, 0)] = 41;
asked_table[IX(1, 1, 1, 1)] = 16777513;
acted_table[IX(1, 1, 1, 1)] = 16777257;
react_table[IX(1, 1, 1, 1)] = 16777513;
ask_table[IX(1, 1, 1, 1)] = 19;
asked_table[IX(1, 1, 1, 2)] = 16;
acted_table[IX(1, 1, 1, 2)] = 16;
react_table[IX(1, 1, 1, 2)] = 16;
ask_table[IX(1, 1, 1, 2)] = 19;
find_table[IX(1, 2, 1, 0)] = 2;
settle_table[IX(1, 2, 1, 0)] = 276;
fate_table[IX(1, 2, 1, 0)] = 9;
asked_table[IX(1, 2, 1, 1)] = 16777257;
acted_table[IX(1, 2, 1, 1)] = 16777513;
react_table[IX(1, 2, 1, 1)] = 16777257;
ask_table[IX(1, 2, 1, 1)] = 19;
asked_table[IX(1, 2, 1, 2)] = 16;
acted_table[IX(1, 2, 1, 2)] = 16;
react_table[IX(1, 2, 1, 2)] = 16;
ask_table[IX(1, 2, 1, 2)] = 19;
find_table[IX(1, 1, 2, 0)] = 1;
settle_table[IX(1, 1, 2, 0)] = 292;
fate_table[IX(1, 1, 2, 0)] = 7;
asked_table[IX(1, 1, 2, 1)] = 16777241;
acted_table[IX(1, 1, 2, 1)] = 16777497;
react_table[IX(1, 1, 2, 1)] = 16777241;
ask_table[IX(1, 1, 2, 1)] = 35;
asked_table[IX(1, 1, 2, 2)] = 32;
acted_table[IX(1, 1, 2, 2)] = 32;
react_table[IX(1, 1, 2, 2)] = 32;
ask_table[IX(1, 1, 2, 2)] = 35;
find_table[IX(1, 2, 2, 0)] = 2;
settle_table[IX(1, 2, 2, 0)] = 36;
fate_table[IX(1, 2, 2, 0)] = 7;
asked_table[IX(1, 2, 2, 1)] = 16777497;
acted_table[IX(1, 2, 2, 1)] = 16777241;
react_table[IX(1, 2, 2, 1)] = 16777497;
ask_table[IX(1, 2, 2, 1)] = 35;
asked_table[IX(1, 2, 2, 2)] = 32;
acted_table[IX(1, 2, 2, 2)] = 32;
react_table[IX(1, 2, 2, 2)] = 32;
ask_table[IX(1, 2, 2, 2)] = 35;
#endif
