package org.evoloop.console;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Names;

/** The commands that every converter has. */
final class ConverterCommands {
    private static final int EVENTS_LISTED = 10;
    private static final List<String> STATUS_OPTIONS = List.of("--all", "--json");

    private final SystemEventConverter converter;
    private final CommandSet commands;
    private final Reader reader;
    private final Supplier<String> next;

    private ConverterCommands(
            SystemEventConverter converter, CommandSet commands, Reader reader, Supplier<String> next) {
        this.converter = converter;
        this.commands = commands;
        this.reader = reader;
        this.next = next;
    }

    /** @param next what to type next, see {@link NextStep} */
    static void addTo(CommandSet commands, SystemEventConverter converter, Reader reader, Supplier<String> next) {
        ConverterCommands own = new ConverterCommands(converter, commands, reader, next);
        commands.add(ConsoleCommand.of("start", "starts converting events", own::start));
        commands.add(ConsoleCommand.of("stop", "stops converting: events are refused until the next start", own::stop));
        commands.add(ConsoleCommand.of(
                        "status [--all|--json]",
                        "shows states, device and current activity; --all adds queue, events, times and components; "
                                + "--json prints all in one line for programs",
                        own::status)
                .completing(before -> before.isEmpty() ? STATUS_OPTIONS : List.of()));
        commands.add(ConsoleCommand.of(
                "watch [SECONDS]",
                "redraws the status every second, or every SECONDS, until a key is pressed",
                own::watch));
        commands.add(ConsoleCommand.of("list", "lists the components, and the spares for exchange", own::list));
        commands.add(ConsoleCommand.of(
                        "exchange COMPONENT SPARE",
                        "replaces a component with a spare, between two events",
                        own::exchange)
                .completing(own::exchangeable));
        commands.add(ConsoleCommand.of(
                "history [N]",
                "shows the last N events, " + EVENTS_LISTED
                        + " by default, and their outcomes; with a journal also events no longer in memory",
                own::history));
        commands.add(ConsoleCommand.of("help [COMMAND]", "lists the commands, or explains one", own::help)
                .completing(before -> before.isEmpty() ? commands.names() : List.of()));
    }

    private void start(List<String> arguments, PrintStream out) {
        boolean running = converter.status().loop() == LoopState.RUNNING;
        converter.start();
        forPeople(
                out,
                text -> text.println((running ? "already running: " : "running: ")
                        + StatusText.states(converter.status())
                        + (reader.isAtTerminal() ? "; " + next.get() : "")));
    }

    private void stop(List<String> arguments, PrintStream out) {
        if (converter.stop()) {
            out.println("stopped: events are refused until start");
        } else {
            String busy = converter.status().components().stream()
                    .filter(component -> component.activity() != ComponentStatus.Activity.WAITING)
                    .map(component -> component.name() + " in its thread " + component.thread())
                    .collect(Collectors.joining(", "));
            out.println(
                    "stopped; running work has to return first, or is abandoned" + (busy.isEmpty() ? "" : ": " + busy));
        }
    }

    private void exchange(List<String> arguments, PrintStream out) {
        requireKnown("component", arguments.get(0), exchangeable(List.of()));
        requireKnown("spare", arguments.get(1), converter.spares());
        converter.exchange(arguments.get(0), arguments.get(1));
        out.println(arguments.get(1) + " has replaced " + arguments.get(0));
    }

    private static void requireKnown(String what, String name, Collection<String> known) {
        if (!known.contains(name)) {
            String meant = Names.meant(name, known);
            throw new IllegalArgumentException("no " + what + " is named " + Names.shown(name)
                    + (!meant.isEmpty()
                            ? meant
                            : "; there are " + (known.isEmpty() ? "none" : String.join(", ", known))));
        }
    }

    private void status(List<String> arguments, PrintStream out) {
        String option = arguments.isEmpty() ? "" : arguments.get(0);
        switch (option) {
            case "" -> forPeople(out, text -> StatusText.brief(converter.status(), text));
            case "--all" -> forPeople(out, text -> StatusText.all(converter.status(), text));
            case "--json" -> out.println(StatusJson.of(converter.status()));
            default ->
                throw new IllegalArgumentException("status takes --all, --json or nothing, not '" + option + "'"
                        + Names.meant(option, STATUS_OPTIONS));
        }
    }

    private void watch(List<String> arguments, PrintStream out) throws InterruptedException {
        Duration period = Duration.ofSeconds(arguments.isEmpty() ? 1 : count("watch", arguments.get(0), 4));
        reader.watch(() -> text(drawn -> StatusText.brief(converter.status(), drawn)), period);
    }

    private void list(List<String> arguments, PrintStream out) {
        forPeople(out, text -> {
            StatusText.components(converter.status().components(), text);
            text.println(
                    "spares      " + (converter.spares().isEmpty() ? "none" : String.join(", ", converter.spares())));
        });
    }

    private List<String> exchangeable(List<String> before) {
        return switch (before.size()) {
            case 0 ->
                converter.status().components().stream()
                        .map(ComponentStatus::name)
                        .toList();
            case 1 -> List.copyOf(converter.spares());
            default -> List.of();
        };
    }

    private void history(List<String> arguments, PrintStream out) {
        int wanted = arguments.isEmpty() ? EVENTS_LISTED : count("history", arguments.get(0), 9);
        StatusText.history(converter.history(wanted), out);
    }

    private static int count(String command, String text, int digits) {
        if (!text.matches("[1-9][0-9]{0," + (digits - 1) + "}")) {
            throw new IllegalArgumentException(
                    command + " takes a number from 1 to " + "9".repeat(digits) + ", not '" + Names.shown(text) + "'");
        }
        return Integer.parseInt(text);
    }

    private void help(List<String> arguments, PrintStream out) {
        forPeople(out, text -> {
            if (arguments.isEmpty()) {
                for (ConsoleCommand command : commands.all()) {
                    String[] lines = command.help().split("\n", 2);
                    text.println(String.format(Locale.ROOT, "  %-24s  %s", command.usage(), lines[0]));
                }
            } else {
                ConsoleCommand command = commands.require(arguments.get(0));
                text.println(command.usage());
                text.println("  " + command.help().replace("\n", "\n  "));
            }
        });
    }

    /** Prints the output of {@code text}, wrapped for the reader. */
    private void forPeople(PrintStream out, Consumer<PrintStream> text) {
        String lines = text(text);
        out.print(reader.isAtTerminal() ? lines : Wrapping.wrap(lines, Wrapping.USUAL_WIDTH));
    }

    /** The output of {@code text}. */
    static String text(Consumer<PrintStream> text) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (PrintStream lines = new PrintStream(bytes, false, StandardCharsets.UTF_8)) {
            text.accept(lines);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
