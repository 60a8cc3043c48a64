package org.evoloop.mqtt.edge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.evoloop.mqtt.Message;
import org.junit.jupiter.api.Test;

/** What waits for a device is bounded. */
class InboxTest {
    private final Inbox inbox = new Inbox("command");

    private List<String> taken(int number) throws InterruptedException {
        List<String> taken = new ArrayList<>();
        for (int each = 0; each < number; each++) {
            taken.add(inbox.take().payload());
        }
        return taken;
    }

    @Test
    void aStateReplacesTheOneThatWaits() throws Exception {
        inbox.put(Message.state("state", "s1"));
        inbox.put(Message.command("command", "c1"));
        inbox.put(Message.state("state", "s2"));
        assertThat(taken(2)).containsExactly("c1", "s2");
    }

    @Test
    void theNewestCommandsAreKept() throws Exception {
        inbox.put(Message.state("state", "s"));
        for (int each = 1; each <= 40; each++) {
            inbox.put(Message.command("command", String.valueOf(each)));
        }
        assertThat(taken(1)).containsExactly("s");
        inbox.put(Message.command("command", "41"));
        assertThat(taken(Inbox.MOST_COMMANDS))
                .containsExactlyElementsOf(
                        IntStream.rangeClosed(26, 41).mapToObj(String::valueOf).toList());
        inbox.put(Message.state("state", "the last"));
        assertThat(taken(1)).containsExactly("the last");
    }
}
