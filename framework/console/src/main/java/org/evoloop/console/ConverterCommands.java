package org.evoloop.console;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.ComponentStatus;

/** The commands that every converter has. */
final class ConverterCommands {
    private static final int EVENTS_LISTED = 10;

    private final SystemEventConverter converter;
    private final CommandSet commands;

    private ConverterCommands(SystemEventConverter converter, CommandSet commands) {
        this.converter = converter;
        this.commands = commands;
    }

    static void addTo(CommandSet commands, SystemEventConverter converter) {
        ConverterCommands own = new ConverterCommands(converter, commands);
        commands.add(ConsoleCommand.of(
                "start", "opens the loop: events are converted from now on", (arguments, out) -> converter.start()));
        commands.add(ConsoleCommand.of("stop", "closes the loop: events are refused until the next start", own::stop));
        commands.add(ConsoleCommand.of(
                        "status [--json]",
                        "shows states, queue, events, times and components; --json prints one line for programs",
                        own::status)
                .completing(before -> before.isEmpty() ? List.of("--json") : List.of()));
        commands.add(ConsoleCommand.of("list", "lists the components, and the spares for exchange", own::list));
        commands.add(ConsoleCommand.of(
                        "exchange COMPONENT SPARE",
                        "puts a spare in the place of a component, between two events",
                        (arguments, out) -> converter.exchange(arguments.get(0), arguments.get(1)))
                .completing(own::exchangeable));
        commands.add(ConsoleCommand.of(
                "history [N]",
                "shows the last N events, " + EVENTS_LISTED
                        + " if not told, and what became of them; a journal reaches further back than memory",
                own::history));
        commands.add(ConsoleCommand.of("help [COMMAND]", "lists the commands, or explains one", own::help)
                .completing(before -> before.isEmpty() ? commands.names() : List.of()));
    }

    private void stop(List<String> arguments, PrintStream out) {
        if (!converter.stop()) {
            String busy = converter.status().components().stream()
                    .filter(component -> component.activity() != ComponentStatus.Activity.WAITING)
                    .map(component -> component.name() + " in its thread " + component.thread())
                    .collect(Collectors.joining(", "));
            out.println("stopped; the rest follows when what was begun has returned or was given up"
                    + (busy.isEmpty() ? "" : ": " + busy));
        }
    }

    private void status(List<String> arguments, PrintStream out) {
        if (arguments.isEmpty()) {
            StatusText.status(converter.status(), out);
        } else if (arguments.get(0).equals("--json")) {
            out.println(StatusJson.of(converter.status()));
        } else {
            throw new IllegalArgumentException("status takes --json or nothing, not '" + arguments.get(0) + "'");
        }
    }

    private void list(List<String> arguments, PrintStream out) {
        StatusText.components(converter.status().components(), out);
        out.println("spares      " + (converter.spares().isEmpty() ? "none" : String.join(", ", converter.spares())));
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
        int wanted = arguments.isEmpty() ? EVENTS_LISTED : count(arguments.get(0));
        StatusText.history(converter.history(wanted), out);
    }

    private static int count(String text) {
        if (!text.matches("[1-9][0-9]{0,8}")) {
            throw new IllegalArgumentException("history takes a number from 1 on, not '" + text + "'");
        }
        return Integer.parseInt(text);
    }

    private void help(List<String> arguments, PrintStream out) {
        if (arguments.isEmpty()) {
            for (ConsoleCommand command : commands.all()) {
                String[] lines = command.help().split("\n", 2);
                out.println(String.format(Locale.ROOT, "  %-26s%s", command.usage(), lines[0]));
            }
        } else {
            ConsoleCommand command = commands.require(arguments.get(0));
            out.println(command.usage());
            out.println("  " + command.help().replace("\n", "\n  "));
        }
    }
}
