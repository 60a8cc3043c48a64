package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/** Each typed line is either executed or answered with one line that says why not. */
@Timeout(30)
class CommandsFuzzTest {

    @MethodSource("seeds")
    @FuzzTest
    void aLineIsPerformedOrAnsweredByOneError(byte[] bytes) {
        LampConverter lamp =
                new LampConverter(LoopConfig.defaults("lamp", new ManualClock()).withoutThreads());
        Captured out = new Captured();
        Captured err = new Captured();
        Console console = new Console(lamp.converter, new ByteArrayInputStream(bytes), out.stream, err.stream);
        console.addCommand(lamp.switchCommand());

        assertThat(console.run()).isZero();

        assertThat(err.lines()).allMatch(line -> line.startsWith("error: "));
        long lines = new String(bytes, StandardCharsets.UTF_8).lines().count();
        assertThat(err.lines()).hasSizeLessThanOrEqualTo((int) lines);
    }

    static List<byte[]> seeds() {
        return List.of(
                text("start\nswitch\nstatus\nstatus --json\nhistory 5\nlist\nstop\nexit\n"),
                text("exchange WallSwitch spareSwitch\nexchange SpareSwitch 'otherSwitch'\nhelp exchange\n"),
                text("\"start\r\nhistory -1\nhistory 99999999999\nstatus --xml\n\u0000\u001b[A"),
                new byte[] {(byte) 0xC3, (byte) 0x28, '\n', (byte) 0xFF, '\n'});
    }

    private static byte[] text(String lines) {
        return lines.getBytes(StandardCharsets.UTF_8);
    }
}
