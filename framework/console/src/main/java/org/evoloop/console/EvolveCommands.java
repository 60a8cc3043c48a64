package org.evoloop.console;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.Probation;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.ShadowReport;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;

/** The commands that change the models of a running converter, and roll back. */
final class EvolveCommands {
    private static final List<String> OPTIONS = List.of(
            "--original", "--mapping", "--when-idle", "--within", "--probation", "--probation-events", "--no-way-back");
    private static final int LONGEST_SECONDS = 86_400;

    private final SystemEventConverter converter;
    private final NewModels models;
    private final OfferedModels offered;

    private EvolveCommands(SystemEventConverter converter, NewModels models, OfferedModels offered) {
        this.converter = converter;
        this.models = models;
        this.offered = offered;
    }

    /**
     * All of these commands.
     *
     * @param models reads the models that the commands name
     * @param offered the models that completion shows
     */
    static List<ConsoleCommand> of(SystemEventConverter converter, NewModels models, OfferedModels offered) {
        EvolveCommands own = new EvolveCommands(converter, models, offered);
        return List.of(
                ConsoleCommand.of("evolve FILE#NAME [OPTION...]", """
                                replaces the new model by another, between two events
                                --original FILE#NAME: the device's model changes, too
                                --mapping FILE: rules for states, timers and functions whose names differ
                                --when-idle SECONDS: waits until nothing has happened for this long
                                --within SECONDS: how long to wait until it is possible (default 30)
                                --probation SECONDS: rolls back if anything goes wrong in this time
                                --probation-events N: the same for this many events
                                --no-way-back: even if a rollback is impossible from some of its states""", own::evolve)
                        .completing(before -> before.isEmpty() ? offered.references() : OPTIONS),
                ConsoleCommand.of("rollback [OPTION...]", """
                                goes back to the models before the last evolve
                                --within SECONDS: how long to wait until it is possible (default 30)""", own::rollBack)
                        .completing(before -> before.isEmpty() ? List.of("--within") : List.of()),
                ConsoleCommand.of("shadow [FILE#NAME|off] [OPTION...]", """
                                lets another new model decide the same events, without acting on its decisions
                                without FILE#NAME: shows what it would have decided differently
                                OPTION: as of evolve, for promote""", own::shadow)
                        .completing(before -> before.isEmpty() ? own.shadows() : OPTIONS),
                ConsoleCommand.of("promote", "makes the shadow's models take over, as evolve does", own::promote));
    }

    private List<String> shadows() {
        List<String> words = new ArrayList<>(offered.references());
        words.add("off");
        return words;
    }

    private void evolve(List<String> arguments, PrintStream out) {
        Evolution evolution = asked(arguments).tellingWaits(why -> ConsoleCommand.sayAtOnce(why, out));
        say(converter.evolve(evolution), evolution.probation(), out);
    }

    private Evolution asked(List<String> arguments) {
        Asked asked = new Asked(new ArrayDeque<>(arguments.subList(1, arguments.size())));
        ModelPair running = converter.knowledge().models();
        String original = asked.original;
        ModelPair next = new ModelPair(
                original == null ? running.original() : models.read(original), models.read(arguments.get(0)));
        Evolution evolution = Evolution.to(converter.knowledgeOf(next))
                .withMapping(asked.mapping(running, next))
                .withDeadline(asked.within)
                .whenIdle(asked.idle)
                .withProbation(new Probation(asked.probation, asked.events, models.watches(arguments.get(0), next)));
        return asked.wayBack ? evolution : evolution.withoutWayBack();
    }

    private void shadow(List<String> arguments, PrintStream out) {
        Optional<Shadow> present = converter.shadow();
        if (!arguments.isEmpty() && !arguments.get(0).equals("off")) {
            say("shadow of " + converter.shadow(asked(arguments)).report(), out);
        } else if (present.isEmpty()) {
            out.println("no shadow; shadow FILE#NAME begins one");
        } else if (!arguments.isEmpty()) {
            say("ended " + present.get().report(), out);
            present.get().close();
        } else {
            ShadowReport report = present.get().report();
            say(report + "; it would be in " + report.at(), out);
            report.differences().forEach(difference -> say(difference.toString(), out));
            report.faults().forEach(fault -> say(fault.toString(), out));
        }
    }

    private void promote(List<String> arguments, PrintStream out) {
        Shadow present = converter
                .shadow()
                .orElseThrow(() -> new IllegalStateException("no shadow; shadow FILE#NAME begins one"));
        say(present.promote(), present.evolution().probation(), out);
    }

    private void rollBack(List<String> arguments, PrintStream out) {
        Deque<String> words = new ArrayDeque<>(arguments);
        Duration within = Evolution.USUAL_DEADLINE;
        while (!words.isEmpty()) {
            String option = words.remove();
            if (!option.equals("--within")) {
                throw new IllegalArgumentException(
                        "rollback has no option " + Names.shown(option) + "; it takes --within SECONDS");
            }
            within = Asked.seconds(option, words);
        }
        say(converter.rollBack(within), Probation.NONE, out);
    }

    /** Names from models may contain line breaks. */
    private static void say(String line, PrintStream out) {
        out.println(Names.inOneLine(line));
    }

    private static void say(Evolution.Result result, Probation probation, PrintStream out) {
        say("evolved to '" + result.model() + "': " + result.before() + " is " + result.after(), out);
        if (!result.steps().isEmpty()) {
            String sent = result.steps().stream()
                    .map(step -> step.trigger().toString())
                    .collect(Collectors.joining(", "));
            say("the device is sent " + sent, out);
        }
        result.carried().forEach(carried -> say("  " + carried, out));
        if (probation.isAny()) {
            out.println("on probation: rolls back by itself if anything goes wrong");
        }
    }

    /** The options as they were typed. */
    private static final class Asked {
        @Nullable
        String original;

        @Nullable
        String mapping;

        Duration idle = Duration.ZERO;
        Duration within = Evolution.USUAL_DEADLINE;
        Duration probation = Duration.ZERO;
        int events;
        boolean wayBack = true;

        Asked(Deque<String> words) {
            while (!words.isEmpty()) {
                String option = words.remove();
                switch (option) {
                    case "--original" -> original = value(option, words);
                    case "--mapping" -> mapping = value(option, words);
                    case "--when-idle" -> idle = seconds(option, words);
                    case "--within" -> within = seconds(option, words);
                    case "--probation" -> probation = seconds(option, words);
                    case "--probation-events" -> events = number(option, words);
                    case "--no-way-back" -> wayBack = false;
                    default ->
                        throw new IllegalArgumentException("evolve has no option " + Names.shown(option)
                                + meantOr(option, "; it takes " + String.join(", ", OPTIONS)));
                }
            }
        }

        private static String meantOr(String option, String otherwise) {
            String meant = Names.meant(option, OPTIONS);
            return meant.isEmpty() ? otherwise : meant;
        }

        private static String value(String option, Deque<String> words) {
            String value = words.poll();
            if (value == null) {
                throw new IllegalArgumentException(option + " needs a value after it");
            }
            return value;
        }

        private static Duration seconds(String option, Deque<String> words) {
            return Duration.ofSeconds(number(option, words));
        }

        private static int number(String option, Deque<String> words) {
            String text = value(option, words);
            if (!text.matches("[0-9]{1,5}") || Integer.parseInt(text) > LONGEST_SECONDS) {
                throw new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "%s takes a number from 0 to %d, not '%s'",
                        option,
                        LONGEST_SECONDS,
                        Names.shown(text)));
            }
            return Integer.parseInt(text);
        }

        Mapping mapping(ModelPair running, ModelPair next) {
            if (mapping == null) {
                return Mapping.byName();
            }
            try {
                return Mapping.parse(mapping, Files.readString(Path.of(mapping)), running, next);
            } catch (IOException e) {
                throw new IllegalArgumentException(
                        mapping + " cannot be read (" + e.getMessage() + "); name a file of mapping rules", e);
            }
        }
    }
}
