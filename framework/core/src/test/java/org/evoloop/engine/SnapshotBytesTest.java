package org.evoloop.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.engine.codec.SnapshotBytes;
import org.evoloop.engine.codec.SnapshotText;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;

class SnapshotBytesTest {
    private static final Rules ROBOT = Scene.robot().rules();

    @Test
    void versionTwoIsWrittenAsEver() {
        assertThat(HexFormat.of().formatHex(SnapshotBytes.write(SnapshotTextTest.onADetour())))
                .isEqualTo(
                        "04010a436c65616e1053706f745761697404140801010a436c65616e0a436c65616e001053706f7457616974020e7469"
                                + "6d656f7574009ac8afa025000000000100000f00080400000000011c0007000a436c65616e00000001170a436c65616e"
                                + "1053706f74576169740853706f740853706f74011053706f74576169740a436c65616e000853706f74040100000a436c"
                                + "65616e0a436c65616e00044f6e010000044f6e0853706f74000853706f7400000008060000000000080220");
    }

    @Test
    void everySnapshotThatIsMetIsReadAsItWasWritten() {
        SnapshotTextTest.assertUnchanged((rules, snapshot) -> SnapshotBytes.read(rules, SnapshotBytes.write(snapshot)));
    }

    @Test
    void whatIsInTheMiddleOfMuchIsReadAsItWasWritten() {
        for (Snapshot snapshot :
                List.of(SnapshotTextTest.eventful(), SnapshotTextTest.onADetour(), SnapshotTextTest.brokenOff())) {
            byte[] bytes = SnapshotBytes.write(snapshot);
            assertThat(SnapshotBytes.read(ROBOT, bytes)).isEqualTo(snapshot);
            assertThat(bytes.length * 2).isLessThan(SnapshotText.write(snapshot).length());
        }
    }

    @Test
    void anyTextsAndNumbersStayWhatTheyAre() {
        Core core = new Core(ROBOT, output -> {});
        core.opened(Long.MIN_VALUE);
        Values values = Values.of("wide", "\u20ac \ud83d\ude00 and half of one: \ud83d")
                .with("narrow", "K\u00fcche")
                .with("long", "x".repeat(1_000))
                .with("number", -0.1)
                .with("never", Double.NaN)
                .with("no", false);
        for (long at : new long[] {-1, 63, 64, -65, Long.MAX_VALUE}) {
            core.observed(new Occurrence.Heard(new Event("Clean"), values, Source.PANEL, true, Set.of(), 0, at));
        }
        Snapshot snapshot = core.snapshot();
        assertThat(snapshot.waiting()).hasSize(5);
        assertThat(SnapshotBytes.read(ROBOT, SnapshotBytes.write(snapshot))).isEqualTo(snapshot);
    }

    @Test
    void whateverDamageIsEitherNoticedOrMakesAnotherSnapshot() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        byte[] bytes = SnapshotBytes.write(SnapshotTextTest.eventful());
        int noticed = 0;
        for (int round = 0; round < 3_000; round++) {
            int place = random.nextInt(bytes.length);
            byte[] damaged = random.nextBoolean() ? bytes.clone() : Arrays.copyOf(bytes, place);
            if (damaged.length == bytes.length) {
                damaged[place] = (byte) random.nextInt();
            }
            try {
                new Core(ROBOT, SnapshotBytes.read(ROBOT, damaged), output -> {});
            } catch (CodecException e) {
                noticed++;
                assertThat(e).as("seed %d", seed).hasMessageStartingWith("snapshot, before byte ");
            }
        }
        assertThat(noticed).as("seed %d", seed).isGreaterThan(1_500);
    }

    @Test
    void anotherVersionIsRefused() {
        byte[] bytes = SnapshotBytes.write(SnapshotTextTest.eventful());
        bytes[0] = 6;
        assertThatThrownBy(() -> SnapshotBytes.read(ROBOT, bytes))
                .isInstanceOf(CodecException.class)
                .hasMessageContaining("version 3 cannot be read, only version 2; use the version of Evoloop");
    }

    @Test
    void aModelWithoutTheStatesIsReported() {
        byte[] bytes = SnapshotBytes.write(SnapshotTextTest.eventful());
        assertThatThrownBy(() -> SnapshotBytes.read(Scene.bulb().rules(), bytes))
                .hasMessageContaining("the model 'original' has no state");
    }
}
