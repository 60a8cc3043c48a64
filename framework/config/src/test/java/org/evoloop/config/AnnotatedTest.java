package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine.Command;

/** The fields of a command with picocli's annotations are options as others are. */
class AnnotatedTest {
    @TempDir
    private Path folder;

    private final Heater heater = new Heater();
    private final Options options = Options.annotated(heater)
            .refined(
                    "degrees",
                    each -> each.checkedBy(text -> {
                        if (Double.parseDouble(text) > 30) {
                            throw new IllegalStateException("--degrees is " + text + ", which is too hot");
                        }
                    }))
            .refined("camera", each -> each.placedBy(Option::resolved).shownBy(text -> "hidden"))
            .alternatives("camera", "simulate")
            .and(Options.of(FanOptions.JOURNAL));

    @Command(name = "heater", description = "Heats 100 %%.", mixinStandardHelpOptions = true)
    private static final class Heater {
        @picocli.CommandLine.Option(names = "--degrees", defaultValue = "21.5", description = "How warm.")
        private double degrees;

        @picocli.CommandLine.Option(
                names = {"--watts", "--power"},
                paramLabel = "N",
                description = "How strong.")
        private @Nullable Integer watts;

        @picocli.CommandLine.Option(names = "--place", split = ",", description = "Where it is.")
        private double @Nullable [] place;

        @picocli.CommandLine.Option(names = "--at", description = "When it begins.")
        private List<String> times = List.of();

        @picocli.CommandLine.Option(names = "--plan", description = "The plan.")
        private @Nullable Path plan;

        @picocli.CommandLine.Option(names = "--camera", description = "What sees it.")
        private @Nullable String camera;

        @picocli.CommandLine.Option(names = "--simulate", description = "Simulates it.")
        private boolean simulate;
    }

    private Settings read(String... arguments) {
        return options.read(List.of(arguments), Map.of(), RuntimeException.class::isInstance);
    }

    private String file(String text) throws IOException {
        return Files.writeString(folder.resolve("heater.yaml"), text).toString();
    }

    private static String answer(Settings settings) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(settings.answer(new PrintStream(out, true, StandardCharsets.UTF_8), System.err))
                .hasValue(0);
        return out.toString(StandardCharsets.UTF_8);
    }

    @Test
    void fileAndCommandLineSetTheFields() throws IOException {
        String file = file(
                "program: heater\ndegrees: 19\npower: 40\nplace: [1, 2]\nat:\n  - 08:00\nplan: plan.txt\ncamera: eye\n"
                        + "journal: kept\n");
        Settings settings = read("--config", file, "--degrees", "20", "--at", "a", "--at=b,c");

        assertThat(heater.degrees).isEqualTo(20);
        assertThat(heater.watts).isEqualTo(40);
        assertThat(heater.place).containsExactly(1, 2);
        assertThat(heater.times).containsExactly("a", "b,c");
        assertThat(heater.plan).isEqualTo(folder.resolve("plan.txt"));
        assertThat(heater.camera).isEqualTo(folder.resolve("eye").toString());
        assertThat(settings.get(FanOptions.JOURNAL)).contains(folder.resolve("kept"));
    }

    @Test
    void theCommandLineTakesThePlaceOfAnAlternative() throws IOException {
        read("--config", file("camera: eye\nat:\n  - 08:00\n"), "--simulate");

        assertThat(heater.camera).isNull();
        assertThat(heater.simulate).isTrue();
        assertThat(heater.times).containsExactly("08:00");
    }

    @Test
    void whatIsNotGivenIsTheFieldsDefault() {
        assertThat(answer(read("--print-config", "--camera", "secret")).replaceAll(" +", " "))
                .contains("program: heater", "degrees: 21.5 # default", "# watts: # default: not set", "camera: hidden")
                .contains("simulate: false # default");
        assertThat(heater.degrees).isEqualTo(21.5);
        assertThat(heater.place).isNull();
    }

    @Test
    void allMistakesAreOneMessage() throws IOException {
        String file = file("degrees: 31\npower: 4.5\nwatts: 4\nplace: 1,x\nsimulate: perhaps\n");
        assertThatThrownBy(() -> read("--config", file, "--at=", "--watt", "3"))
                .isInstanceOf(ConfigException.class)
                .message()
                .satisfies(error -> assertThat(
                                error.replace(folder.toString(), "D").lines())
                        .containsExactly(
                                "the options have 7 mistakes:",
                                "  there is no option --watt; did you mean watts?",
                                "  --at has an empty value; write one, or leave it out",
                                "  D/heater.yaml:1: degrees is 31, which is too hot",
                                "  D/heater.yaml:2: watts: '4.5' is not a whole number",
                                "  D/heater.yaml:3: watts is given twice, first in line 2; keep one",
                                "  D/heater.yaml:4: place: 'x' is not a number",
                                "  D/heater.yaml:5: simulate: 'perhaps' is neither true nor false; write one of them"));
        assertThatThrownBy(() -> read("--watts", "1", "--power", "2")).hasMessage("--watts is given twice; keep one");
        assertThatThrownBy(() -> options.read(List.of("--degrees", "31"), Map.of()))
                .isInstanceOf(IllegalStateException.class);
    }

    @Test
    void helpIsPicoclis() {
        assertThat(answer(read("-h", "--degrees", "31")))
                .startsWith("Usage: heater ")
                .contains("Heats 100 %.", "--watts, --power=N", "--journal=DIR", "--config=FILE");
        assertThat(options.commandLine().getCommandName()).isEqualTo("heater");
    }
}
