package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.function.BiFunction;
import org.evoloop.engine.Scene.Act;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SnapshotTextTest {
    private static final Rules ROBOT = Scene.robot().rules();

    /** A busy robot: a plan of two steps in doubt, and a fact, a press and a function's event that wait. */
    static Snapshot eventful() {
        ScriptedCore core = new ScriptedCore(Scene.robot());
        core.press("Clean").begins().sent(false).press("Clean").begins().sent(false);
        core.press("Clean").ready().planned();
        core.press("Clean").begins().own("Clean").givenUp();
        core.ready().planned();
        core.observe(new Occurrence.Heard(
                new Event("Clean", List.of("hot", "50 % full")),
                Values.of("temperature", 21.5)
                        .with("room", "\"Küche\"\\\n\ud83d\ude00")
                        .with("night", true),
                Source.PANEL,
                true,
                Set.of("b", "a"),
                Occurrence.ANY_VISIT,
                77));
        core.press("Spot").observe(new Occurrence.Asked(new Event("Spot"), Values.NONE, 3, 78));
        return core.core.snapshot();
    }

    /** A robot about to be sent the first of two steps. */
    static Snapshot onADetour() {
        ScriptedCore core = new ScriptedCore(Scene.robot());
        core.press("Clean").begins().sent(false).press("Clean").begins().sent(false);
        core.press("Clean").ready().planned();
        return core.press("Clean").begins().core.snapshot();
    }

    /** The same robot after its second step has failed, about to be sent back. */
    static Snapshot brokenOff() {
        ScriptedCore core = new ScriptedCore(Scene.robot().onFailure(OnFailure.GO_BACK));
        core.press("Clean").begins().sent(false).press("Clean").begins().sent(false);
        core.press("Clean").ready().planned();
        core.press("Clean").begins().sent(false);
        return core.input(new Input.Failed(core.number(), "the \"cable\" is loose", 99))
                .core
                .snapshot();
    }

    @Test
    void versionTwoIsWrittenAsEver() throws IOException {
        isWrittenAsIn("snapshot-2-doubt.txt", eventful());
        isWrittenAsIn("snapshot-2-plan.txt", onADetour());
        isWrittenAsIn("snapshot-2-broken.txt", brokenOff());
    }

    private static void isWrittenAsIn(String golden, Snapshot snapshot) throws IOException {
        try (InputStream file = SnapshotTextTest.class.getResourceAsStream(golden)) {
            String text = new String(Objects.requireNonNull(file).readAllBytes(), StandardCharsets.UTF_8);

            assertThat(SnapshotText.write(snapshot)).isEqualTo(text);
            assertThat(SnapshotText.read(ROBOT, text)).isEqualTo(snapshot);
        }
    }

    @Test
    void everySnapshotThatIsMetIsReadAsItWasWritten() {
        assertUnchanged((rules, snapshot) -> SnapshotText.read(rules, SnapshotText.write(snapshot)));
    }

    /** @param writtenAndRead writes a snapshot and reads it again */
    static void assertUnchanged(BiFunction<Rules, Snapshot, Snapshot> writtenAndRead) {
        for (Scene scene : List.of(
                Scene.robot().outOfOrder().with(1, Act.PRESS, Act.OWN, Act.GIVE_UP, Act.JUMP),
                DeviceStateScenes.door().with(1, Act.PRESS, Act.OWN, Act.GIVE_UP, Act.END),
                RandomPair.scene(1).with(1, Act.PRESS, Act.OWN, Act.FAIL, Act.DISMISS),
                RandomPair.scene(2).with(1, Act.PRESS, Act.FAIL, Act.RAISE, Act.ASK))) {
            Exploration.of(scene, 12, (rules, snapshot) -> {
                Snapshot read = writtenAndRead.apply(rules, snapshot);
                if (!read.equals(snapshot)) {
                    assertThat(read).as("%s", scene).isEqualTo(snapshot);
                }
            });
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "evoloop-snapshot 2|evoloop-snapshot 3|line 1: version 3 cannot be read, only version 2; use the version of Evoloop that wrote it",
                "evoloop-snapshot 2|evoloop-models 2|line 1: this is not a snapshot of Evoloop; its first line is",
                "open true|open maybe|line 2: 'true' or 'false' was expected, not 'maybe'; the text is damaged",
                "at \"Off\"|at \"Aus\"|line 3: the model 'original' has no state 'Aus'; use the models with which",
                "at \"Off\" \"Off\"|at \"Off|line 3: a string has no closing quote",
                "at \"Off\" \"Off\"|at \"Off\"|line 3: a quoted string was expected",
                "at \"Off\" \"Off\"|at \"O\\ff\" \"Off\"|line 3: a string has an unknown escape sequence",
                "sent 0 0|sent zero 0|line 4: a number was expected, not 'zero'",
                "sent 0 0|sent -1 0|line 4: no number below 0 was expected",
                "sent 0 0|sent 0 0 0|line 4: '0' is too much",
                "sent 0 0|went 0 0|line 4: 'sent' was expected, not 'went'",
                "by none|by \"Off\" \"Clean\" 0 \"Spot\"|line 6: the model 'new' has no transition Off --Clean--> Spot",
                "waiting 0|waiting 3|line 11: 'pending' was expected, not 'doubt'",
                "end|end, or not|line 15: 'end' was expected",
                "work none|work 0 0 sending \"\"|line 13: 'pending' was expected, not 'tally'"
            })
    void mistakesAreReportedWithTheirLines(String right, String wrong, String message) {
        Core core = new Core(ROBOT, output -> {});
        core.opened(0);
        String text = SnapshotText.write(core.snapshot());
        assertThat(text).contains(right);

        assertThatThrownBy(() -> SnapshotText.read(ROBOT, text.replace(right, wrong)))
                .isInstanceOf(CodecException.class)
                .hasMessageStartingWith("snapshot, " + message);
    }

    @Test
    void whateverDamageIsEitherNoticedOrMakesAnotherSnapshot() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        String text = SnapshotText.write(eventful());
        int noticed = 0;
        for (int round = 0; round < 3_000; round++) {
            StringBuilder damaged = new StringBuilder(text);
            int place = random.nextInt(text.length());
            if (random.nextBoolean()) {
                damaged.setCharAt(place, "0 -\"\\nx\n".charAt(random.nextInt(8)));
            } else {
                damaged.delete(place, Math.min(text.length(), place + 1 + random.nextInt(40)));
            }
            try {
                new Core(ROBOT, SnapshotText.read(ROBOT, damaged.toString()), output -> {});
            } catch (CodecException e) {
                noticed++;
                assertThat(e).as("seed %d, %s", seed, damaged).hasMessageStartingWith("snapshot, line ");
            }
        }
        assertThat(noticed).as("seed %d", seed).isGreaterThan(2_000);
    }

    @Test
    void aModelWithoutTheStatesIsReported() {
        String text = SnapshotText.write(eventful());
        assertThatThrownBy(() -> SnapshotText.read(Scene.bulb().rules(), text))
                .hasMessageContaining("the model 'original' has no state");
    }
}
