package org.evoloop.page;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.console.OfferedModels;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.Component;
import org.evoloop.payload.JsonObject;

/**
 * The controls of the page: start, stop, exchange, and those of the application's commands that can be buttons because
 * they take no argument or one of some known words. If the program supports it, other models that it offers can take
 * over or run as a shadow: users of the page cannot name files.
 *
 * <p>Threading: thread-safe.
 */
final class Controls {
    private static final Set<String> OF_EVERY_CONVERTER = Set.of("start", "stop", "exchange");

    private static final Pattern OF_MODELS = Pattern.compile(
            "rollback|promote|shadow off|(?:evolve|shadow) \"([^\"]+)\"(?: --(?:within|probation) [0-9]+)*");

    private final Console console;
    private final SystemEventConverter converter;

    Controls(Console console) {
        this.console = console;
        this.converter = console.converters().get(0);
    }

    /**
     * {@code commands}: {@code name}, {@code help}, {@code choices}; {@code spares}, by role; {@code evolves}, and if so, the
     * offered {@code models}.
     */
    JsonObject offered() {
        List<JsonObject> commands = new ArrayList<>();
        for (ConsoleCommand command : buttons()) {
            commands.add(new JsonObject()
                    .put("name", command.name())
                    .put("help", command.help())
                    .putTexts("choices", choices(command)));
        }
        return new JsonObject()
                .put("commands", commands)
                .put("spares", spares())
                .put("evolves", console.offeredModels().isPresent())
                .putTexts("models", models());
    }

    /** The names of the spares for each role. */
    private JsonObject spares() {
        JsonObject byRole = new JsonObject();
        for (Component.Role role : Component.Role.values()) {
            byRole.putTexts(role.name().toLowerCase(Locale.ROOT), converter.spares(role));
        }
        return byRole;
    }

    private List<String> models() {
        return console.offeredModels().map(OfferedModels::references).orElse(List.of());
    }

    private List<ConsoleCommand> buttons() {
        return console.addedCommands().stream()
                .filter(ConsoleCommand::offered)
                .filter(command -> arguments(command) == 0
                        || (arguments(command) == 1 && !choices(command).isEmpty()))
                .toList();
    }

    private static int arguments(ConsoleCommand command) {
        return command.usage().split(" +").length - 1;
    }

    private static Collection<String> choices(ConsoleCommand command) {
        return arguments(command) == 0 ? List.of() : command.completion().apply(List.of());
    }

    /**
     * Performs a command, on the caller's thread.
     *
     * @param line the command as on the console
     * @return {@code status}, {@code output}, {@code error}
     */
    JsonObject perform(String line) throws InterruptedException {
        String name = line.strip().split("\\s", 2)[0];
        if (!OF_EVERY_CONVERTER.contains(name)
                && buttons().stream().noneMatch(command -> command.name().equals(name))
                && !isOfModels(line)) {
            return new JsonObject().put("status", 2).put("output", "").put("error", "the page has no command " + name);
        }
        ByteArrayOutputStream results = new ByteArrayOutputStream();
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        int status = console.perform(
                line,
                new PrintStream(results, true, StandardCharsets.UTF_8),
                new PrintStream(errors, true, StandardCharsets.UTF_8));
        return new JsonObject()
                .put("status", status)
                .put("output", results.toString(StandardCharsets.UTF_8).strip())
                .put("error", errors.toString(StandardCharsets.UTF_8).strip().replaceFirst("^error: ", ""));
    }

    private boolean isOfModels(String line) {
        Matcher asked = OF_MODELS.matcher(line.strip());
        return console.offeredModels().isPresent()
                && asked.matches()
                && (asked.group(1) == null || models().contains(asked.group(1)));
    }
}
