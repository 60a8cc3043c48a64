package org.evoloop.config;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The options of a program for a fan, one of each kind. */
final class FanOptions {
    static final Option<Boolean> START = Option.flag("start", "Starts at once.");
    static final Option<Boolean> SIMULATE =
            Option.flag("simulate", "Simulates the fan.").insteadOf(Set.of("port"));
    static final Option<String> PORT =
            Option.value("port", "PATH", "Where the fan is.", text -> text).insteadOf(Set.of("simulate"));
    static final Option<Integer> SPEED =
            Option.value("speed", "N", "How fast it turns.", FanOptions::speed).withDefault("3");
    static final Option<String> BREEZE_AT = Option.value("breeze-at", "TIME", "When a breeze begins.", text -> text)
            .repeated();
    static final Option<Path> JOURNAL = Option.path("journal", "DIR", "Where it keeps its journal (default: nowhere).");
    static final Option<Path> MODELS = Option.file("models", "FILE", "Its models.");
    static final Secret PASSWORD = Secret.named("fan-password", "The file with its password.", "FAN_PASSWORD");

    static final Options ALL = Options.named("fan", "Runs a fan.")
            .and(Options.of(START, SIMULATE, PORT, SPEED, BREEZE_AT), Options.of(JOURNAL, MODELS))
            .with(PASSWORD)
            .checking((settings, mistakes) -> {
                if (settings.isOn(SIMULATE) == settings.get(PORT).isPresent()) {
                    mistakes.add("say which fan: --port PATH or --simulate");
                }
            });

    private FanOptions() {}

    private static int speed(String text) {
        if (!text.matches("[1-9]")) {
            throw new IllegalArgumentException("--speed is " + text + ", allowed is 1 to 9");
        }
        return Integer.parseInt(text);
    }

    static Settings read(String... arguments) {
        return ALL.read(List.of(arguments), Map.of());
    }
}
