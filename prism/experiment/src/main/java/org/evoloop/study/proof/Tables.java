package org.evoloop.study.proof;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried;
import org.evoloop.migration.Fate;
import org.evoloop.migration.Succession;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** The compiled decision tables of an evolution, in Promela, for {@code prism/proof/core.pml}. */
final class Tables {
    private final EvolvingPair evolution;
    private final StringBuilder out = new StringBuilder();

    private Tables(EvolvingPair evolution) {
        this.evolution = evolution;
    }

    static String of(EvolvingPair evolution) {
        return new Tables(evolution).write();
    }

    private String write() {
        line("/* Included twice: first declarations, then, with FILLING, the statements that fill the tables. */");
        line("#ifndef FILLING");
        names("device", evolution.deviceStates());
        names("system", evolution.systemStates());
        names("event", evolution.events());
        Configuration initial = evolution.rules().table().models().initial();
        int events = evolution.events().size() + 1;
        define("EVENTS1", events);
        define("SYSTEM1", evolution.systemStates().size() + 1);
        define("DEVICE1", evolution.deviceStates().size() + 1);
        define("INITIAL_DEVICE", evolution.number(initial.original(), true));
        define("INITIAL_SYSTEM", evolution.number(initial.evolved(), false));
        define("CAPACITY", evolution.rules().queueCapacity());
        line("#define IX(p, d, s, e) ((((p) * DEVICE1 + (d)) * SYSTEM1 + (s)) * EVENTS1 + (e))");
        line("#define OWN(d, e) own_table[(d) * EVENTS1 + (e)]");
        for (String table : List.of(
                "asked_table",
                "acted_table",
                "react_table",
                "ask_table",
                "settle_table",
                "find_table",
                "timer_table",
                "fate_table",
                "knows_table",
                "function_table",
                "elsewhere_table")) {
            line("hidden int " + table + "[2 * DEVICE1 * SYSTEM1 * EVENTS1];");
        }
        line("hidden byte own_table[DEVICE1 * EVENTS1];");
        line("hidden byte is_own_table[EVENTS1];");
        line("hidden byte has_table[EVENTS1];");
        line("hidden byte only_table[EVENTS1];");
        choices();
        line("#else");
        events(evolution.rules().table());
        models(false);
        models(true);
        line("#endif");
        return out.toString();
    }

    private void names(String kind, List<?> members) {
        for (int index = 0; index < members.size(); index++) {
            line("//@ " + kind + " " + (index + 1) + " " + members.get(index));
        }
    }

    private void define(String name, int value) {
        line("#define " + name + " " + value);
    }

    private void line(String line) {
        out.append(line).append('\n');
    }

    private void put(String table, String index, int value) {
        if (value != 0) {
            line(table + "[" + index + "] = " + value + ";");
        }
    }

    // What may happen

    private void choices() {
        choice(
                "choose_button",
                evolution.pressed().stream()
                        .map(event -> "event = " + evolution.number(event))
                        .toList());
        choice(
                "choose_asked",
                evolution.sendable().stream()
                        .map(event -> "event = " + evolution.number(event))
                        .toList());
        choice(
                "choose_raised",
                evolution.raised().stream()
                        .map(event -> "event = " + evolution.number(event))
                        .toList());
        choice(
                "choose_device_state",
                evolution.deviceStates().stream()
                        .map(state -> "event = " + evolution.number(state, true))
                        .toList());
        List<String> possible = evolution.own().stream()
                .map(event -> "OWN(device, " + evolution.number(event) + ") != 0")
                .toList();
        choice(
                "choose_own",
                evolution.own().stream()
                        .map(event -> "OWN(device, " + evolution.number(event) + ") != 0 -> event = "
                                + evolution.number(event))
                        .toList());
        line("#define CAN_ACT (" + String.join(" || ", possible) + ")");
    }

    private void choice(String name, List<String> options) {
        line("inline " + name + "() {\n  if\n"
                + options.stream().map(option -> "  :: " + option + "\n").collect(Collectors.joining()) + "  fi\n}");
    }

    // Decisions

    private void events(DecisionTable table) {
        for (Event event : evolution.events()) {
            int number = evolution.number(event);
            put("is_own_table", "" + number, table.isDevicesOwn(event) ? 1 : 0);
            State only = table.onlyTarget(event);
            put("has_table", "" + number, table.models().original().triggers().contains(event) ? 1 : 0);
            put("only_table", "" + number, only == null ? 0 : evolution.number(only, true));
            for (State state : evolution.deviceStates()) {
                Step own = table.ownStep(state, event, guard -> false);
                int from = evolution.number(state, true);
                put(
                        "own_table",
                        from + " * EVENTS1 + " + number,
                        own == null ? 0 : evolution.number(own.target(), true));
            }
        }
    }

    private void models(boolean swapped) {
        DecisionTable table = evolution.rules(swapped).table();
        Succession succession = evolution.swap(swapped).succession();
        for (Event event : evolution.events()) {
            String index = "IX(" + (swapped ? 1 : 0) + ", 0, 0, " + evolution.number(event) + ")";
            put("knows_table", index, table.names().knows(event) ? 1 : 0);
        }
        for (State system : table.models().evolved().states()) {
            List<Event> timers = evolution.timer(swapped, system);
            if (timers.size() > 1) {
                throw new IllegalArgumentException("state " + system + " has more than one timer: " + timers);
            }
            put("timer_table", index(swapped, 0, system, 0), timers.isEmpty() ? 0 : evolution.number(timers.get(0)));
            int function = !table.isNew(system) ? 0 : table.needsDevice(system) ? 2 : 1;
            put("function_table", index(swapped, 0, system, 0), function);
            for (State device : evolution.deviceStates()) {
                int at = evolution.number(device, true);
                Configuration both = new Configuration(device, system);
                Decision found = table.find(both, device);
                put(
                        "find_table",
                        index(swapped, at, system, 0),
                        evolution.number(found.after().evolved(), false));
                put("elsewhere_table", index(swapped, at, system, 0), table.isWhereNeeded(both) ? 0 : 1);
                put("settle_table", index(swapped, at, system, 0), code(table.settle(both)));
                put("fate_table", index(swapped, at, system, 0), code(succession.fate(both)));
                for (Event event : evolution.events()) {
                    int number = evolution.number(event);
                    String index = index(swapped, at, system, number);
                    Event resolved = table.resolve(both, event, guard -> false);
                    put("asked_table", index, code(table.decide(both, resolved, false)));
                    put("acted_table", index, code(table.decide(both, resolved, true)));
                    put("react_table", index, code(table.react(both, resolved, null, false)));
                    put("ask_table", index, code(table.ask(both, event, guard -> false)));
                }
            }
        }
    }

    private String index(boolean swapped, int device, State system, int event) {
        return "IX(" + (swapped ? 1 : 0) + ", " + device + ", " + evolution.number(system, false) + ", " + event + ")";
    }

    private int code(Decision decision) {
        return Codes.of(decision, evolution);
    }

    private int code(Fate fate) {
        if (!(fate instanceof Fate.Maps maps)) {
            return 0;
        }
        boolean timer = maps.carried().stream()
                .anyMatch(each -> each.part() == Carried.What.TIMER && each.how() == Carried.How.KEPT);
        boolean function = maps.carried().stream()
                .allMatch(each -> each.part() == Carried.What.TIMER || each.how() == Carried.How.KEPT);
        return 1
                | evolution.number(maps.at().evolved(), false) << 1
                | (maps.steps().isEmpty() ? 0 : 1 << 5)
                | (timer ? 1 << 6 : 0)
                | (function ? 1 << 7 : 0)
                | (maps.steps().isEmpty() && !maps.to().equals(maps.at()) ? 1 << 8 : 0);
    }
}
