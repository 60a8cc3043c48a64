package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

class UsersMistakesTest {
    private final StringWriter err = new StringWriter();

    @CommandLine.Command(name = "lamp")
    private record Failing(Exception failure) implements Callable<Integer> {
        enum Light {
            COLD,
            WARM
        }

        @CommandLine.Option(names = "--light")
        void light(Light unused) {}

        @Override
        public Integer call() throws Exception {
            throw failure;
        }
    }

    private int run(Exception failure, String... arguments) {
        CommandLine commandLine = new CommandLine(new Failing(failure)).setErr(new PrintWriter(err, true));
        return UsersMistakes.reportedBy(commandLine, IllegalArgumentException.class::isInstance)
                .execute(arguments);
    }

    @Test
    void aWrongOptionIsOneLineThatNamesTheHelp() {
        assertThat(run(new IllegalStateException(), "--dim")).isEqualTo(2);
        assertThat(err.toString().lines())
                .singleElement()
                .asString()
                .startsWith("error: Unknown option: '--dim'")
                .endsWith("(see lamp --help)");
    }

    @Test
    void aWordTooManyIsNamed() {
        assertThat(run(new IllegalStateException(), "on", "off")).isEqualTo(2);
        assertThat(err.toString().lines()).containsExactly("error: more than it takes: on off (see lamp --help)");
    }

    @Test
    void wordsThatAreAllowedAreNamed() {
        assertThat(run(new IllegalStateException(), "--light", "pink")).isEqualTo(2);
        assertThat(err.toString().lines())
                .containsExactly("error: --light: 'pink' is none of cold, warm (see lamp --help)");
    }

    @Test
    void commandsThatThereAreAreNamed() {
        CommandLine house = new CommandLine(
                        CommandLine.Model.CommandSpec.create().name("house"))
                .addSubcommand("lamp", new Failing(new IllegalStateException()))
                .setErr(new PrintWriter(err, true));
        assertThat(UsersMistakes.reportedBy(house, IllegalArgumentException.class::isInstance)
                        .execute("lmap"))
                .isEqualTo(2);
        assertThat(err.toString().lines())
                .containsExactly("error: there is no command 'lmap'; there are lamp (see house --help)");
    }

    @Test
    void anErrorThatTheUserCanFixIsOnlyItsMessage() {
        assertThat(run(new IllegalArgumentException("there is no bulb; screw one in")))
                .isEqualTo(2);
        assertThat(err.toString().lines()).containsExactly("error: there is no bulb; screw one in");
    }

    @Test
    void anyOtherFailureShowsWhereItHappened() {
        assertThat(run(new IllegalStateException("dark"))).isEqualTo(1);
        assertThat(err.toString()).contains("IllegalStateException: dark", "\tat " + UsersMistakesTest.class.getName());
    }
}
