package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class WrappingTest {
    @Test
    void whatFollowsIsIndentedToWhereTheTextBegins() {
        assertThat(Wrapping.wrap("states      original Off, new Off\n", 24))
                .isEqualTo("states      original\n            Off, new Off\n");
        assertThat(Wrapping.wrap("  help [COMMAND]  lists all, or explains one", 28))
                .isEqualTo("  help [COMMAND]  lists all,\n              or explains\n              one");
        assertThat(Wrapping.wrap("  in a paragraph of its own", 16)).isEqualTo("  in a paragraph\n  of its own");
    }

    @Test
    void aWordThatIsTooLongHasALineOfItsOwn() {
        assertThat(Wrapping.wrap("see /dev/serial/by-id/usb-FTDI now", 12))
                .isEqualTo("see\n/dev/serial/by-id/usb-FTDI\nnow");
        assertThat(Wrapping.wrap("/dev/serial/by-id/usb-FTDI", 12)).isEqualTo("/dev/serial/by-id/usb-FTDI");
    }

    @Test
    void whatFitsOrIsForProgramsStaysAsItIs() {
        assertThat(Wrapping.wrap("just fits\n\n  and   this", 13)).isEqualTo("just fits\n\n  and   this");
        assertThat(Wrapping.wrap("{\"name\":\"two words\"}", 5)).isEqualTo("{\"name\":\"two words\"}");
    }

    @Test
    void noWordIsLostAndNoLineIsTooLong() {
        long seed = new Random().nextLong();
        RandomGenerator random = new Random(seed);
        for (int round = 0; round < 2_000; round++) {
            String label = round % 2 == 0 ? "" : "label   ";
            String text = label
                    + random.ints(1 + random.nextInt(40), 1, 13)
                            .mapToObj(letters -> "w".repeat(letters))
                            .collect(Collectors.joining(" "));
            int width = 30 + random.nextInt(20);

            String wrapped = Wrapping.wrap(text, width);

            assertThat(wrapped.split("\\s+")).as("seed %d: '%s'", seed, text).isEqualTo(text.split("\\s+"));
            int most = width;
            assertThat(wrapped.lines()).as("seed %d: '%s'", seed, text).allMatch(line -> line.length() <= most);
        }
    }
}
