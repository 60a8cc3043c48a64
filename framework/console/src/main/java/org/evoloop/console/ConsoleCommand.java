package org.evoloop.console;

import java.io.PrintStream;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.converter.PushMonitor;
import org.evoloop.statemachine.Names;

/**
 * A command of a {@link Console}.
 *
 * <pre>{@code
 * ConsoleCommand.of("level PERCENT", "sets the brightness", (arguments, out) -> lamp.level(arguments.get(0)))
 *         .completing(before -> List.of("50", "100"));
 * }</pre>
 *
 * <p>Threading: immutable; its action is called on the console's thread or another, one at a time for all
 * that an application adds; its completion on the console's.
 *
 * @param usage the command's name and one word for each argument, optional ones in brackets: {@code exchange COMPONENT
 *     SPARE}, {@code status [--json]}; the last may stand for any number, {@code [OPTION...]}. The console refuses any
 *     other number of arguments
 * @param help what the command does, for {@code help}; the first line is shown in the list of all commands
 * @param action what it does
 * @param completion the words that may follow those given, which begin with the first argument
 * @param offered whether it is for everybody who operates the converter: it is then suggested as the next step, and a
 *     button on the page
 * @since 0.1
 */
public record ConsoleCommand(
        String usage,
        String help,
        Action action,
        Function<List<String>, Collection<String>> completion,
        boolean offered) {

    /** The action of a command. */
    @FunctionalInterface
    public interface Action {
        /**
         * Performs the command.
         *
         * @param arguments the arguments, as many as the usage allows
         * @param out for results, which are shown in one piece when this returns
         * @throws Exception any failure: its message, which should say how to fix it, becomes the console's error line
         */
        void run(List<String> arguments, PrintStream out) throws Exception;
    }

    /** The action of a command about something that has a name. */
    @FunctionalInterface
    public interface NamedAction {
        /**
         * Performs the command.
         *
         * @param name the name, with its blanks
         * @param rest the arguments that follow it
         * @throws Exception as {@link Action#run}
         */
        void run(String name, List<String> rest) throws Exception;
    }

    /**
     * A command whose first argument is one of these names, which are completed. A blank in a name is typed as {@code
     * _}.
     *
     * @param names what there is when the command is typed; any other name is refused
     */
    public static ConsoleCommand naming(
            String usage, String help, Supplier<? extends Collection<?>> names, NamedAction action) {
        return of(
                        usage,
                        help,
                        (arguments, out) -> action.run(
                                named(arguments.get(0), names.get()), arguments.subList(1, arguments.size())))
                .completing(before -> before.isEmpty() ? typed(names.get()) : List.of());
    }

    /** The command {@code press EVENT}: raises an event of the controller; see the method with a usage. */
    public static ConsoleCommand press(PushMonitor controller, Supplier<? extends Collection<?>> events) {
        return press(
                        "press EVENT",
                        "an event of the controller",
                        controller,
                        arguments -> named(arguments.get(0), events.get()))
                .completing(before -> before.isEmpty() ? typed(events.get()) : waiting(1, before));
    }

    /**
     * A command that raises an event of the controller: as {@link PushMonitor#press(String)}. With the option {@code
     * --wait}, which the usage does not name, it waits for the outcome, prints it, and fails unless the event was handled;
     * {@code ctl} waits unless {@code --no-wait} is given. Presses do not wait for other commands.
     *
     * @param event the event that these arguments name
     */
    public static ConsoleCommand press(
            String usage, String help, PushMonitor controller, Function<List<String>, String> event) {
        int arguments = usage.split(" +").length - 1;
        return of(usage, help + "\n" + PressAction.HELP, new PressAction(controller, event))
                .completing(before -> waiting(arguments, before));
    }

    private static List<String> waiting(int arguments, List<String> before) {
        return before.size() == arguments ? List.of(PressAction.WAIT) : List.of();
    }

    private static String named(String typed, Collection<?> names) {
        return names.stream()
                .map(Object::toString)
                .filter(name -> typed(List.of(name)).contains(typed))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "there is no '" + typed + "' here" + Names.hint(typed, typed(names))));
    }

    private static List<String> typed(Collection<?> names) {
        return names.stream()
                .map(name -> name.toString().replaceAll("\\s", "_"))
                .sorted()
                .toList();
    }

    /** A command without completion of its arguments. */
    public static ConsoleCommand of(String usage, String help, Action action) {
        return new ConsoleCommand(usage, help, action, before -> List.of(), true);
    }

    /**
     * Prints a line before the command has ended, for one that has to wait. What it prints otherwise appears in one piece
     * once it has ended.
     */
    public static void sayAtOnce(String line, PrintStream out) {
        out.println(Names.inOneLine(line));
        out.flush();
    }

    /** A copy with another completion. */
    public ConsoleCommand completing(Function<List<String>, Collection<String>> words) {
        return new ConsoleCommand(usage, help, action, words, offered);
    }

    /** A copy for those who try something out, such as a command that lets a simulated device act; not offered. */
    public ConsoleCommand notOffered() {
        return new ConsoleCommand(usage, help, action, completion, false);
    }

    /** What the user types. */
    public String name() {
        return words().get(0);
    }

    /** Whether the command can be called with this number of arguments. */
    boolean accepts(int arguments) {
        List<String> words = words();
        long required = words.stream().filter(word -> !word.startsWith("[")).count();
        boolean open = words.get(words.size() - 1).endsWith("...]");
        return required <= arguments + 1 && (open || arguments + 1 <= words.size());
    }

    private List<String> words() {
        return Arrays.asList(usage.split(" +"));
    }
}
