package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BrokerAddressTest {
    private static final Map<String, String> SECRET = Map.of(BrokerAddress.PASSWORD, "s3cret");

    @TempDir
    private Path directory;

    @ParameterizedTest
    @CsvSource({
        "mqtt://broker, mqtt://broker:1883",
        "mqtts://broker, mqtts://broker:8883",
        "mqtt://ha@broker:1884/, mqtt://ha@broker:1884",
        "mqtt://[::1]:1883, mqtt://[::1]:1883",
        "mqtts://192.168.1.2?id=hall&discovery=ha, mqtts://192.168.1.2:8883"
    })
    void whereTheBrokerIs(String url, String read) {
        assertThat(BrokerAddress.parse(url, Map.of())).hasToString(read);
    }

    @Test
    void theIdIsTheConvertersNameUnlessTheAddressHasOne() {
        assertThat(BrokerAddress.parse("mqtt://b", Map.of()).id("my lamp")).isEqualTo("my_lamp");
        assertThat(BrokerAddress.parse("mqtt://b?id=hall", Map.of()).id("lamp")).isEqualTo("hall");
    }

    @Test
    void thePasswordComesFromTheEnvironmentOrAFile() throws Exception {
        assertThat(BrokerAddress.parse("mqtt://ha@b", SECRET).password()).isEqualTo("s3cret");
        assertThat(BrokerAddress.parse("mqtt://b", SECRET).password()).isNull();
        Path file = Files.writeString(directory.resolve("password"), "other\n");
        assertThat(BrokerAddress.parse("mqtt://ha@b?password-file=" + file, SECRET)
                        .password())
                .isEqualTo("other");
        assertThat(BrokerAddress.parse("mqtt://ha@b", SECRET).toString()).doesNotContain("s3cret");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "broker",
                "http://broker",
                "mqtt://",
                "mqtt:///x",
                "mqtt://broker/topic",
                "mqtt://broker:0",
                "mqtt://broker:99999",
                "mqtt://bro ker",
                "mqtt://broker#x"
            })
    void whatNamesNoBrokerIsRefusedWithAnExample(String url) {
        assertThatThrownBy(() -> BrokerAddress.parse(url, Map.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(url)
                .hasMessageContaining("mqtt://HOST");
    }

    @ParameterizedTest
    @ValueSource(strings = {"mqtt://ha:s3cret@b", "mqtt://ha:s3cret@b ad", "mqtt://ha:s3@cret@b", "http://ha:s3cret@b"})
    void aPasswordInTheUrlIsRefusedAndNotShown(String url) {
        assertThatThrownBy(() -> BrokerAddress.parse(url, Map.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageNotContaining("cret");
    }

    @ParameterizedTest
    @CsvSource({
        "mqtt://b?user=x, 'user'",
        "mqtt://b?id=, 'id'",
        "mqtt://b?id=a/b, id=a/b",
        "mqtt://b?discovery=a%23, discovery",
        "mqtt://b?ca=/x, mqtts://",
        "mqtt://b?password-file=/x, USER@HOST",
        "mqtt://ha@b?password-file=/no/such, /no/such"
    })
    void whatFollowsTheQuestionMarkIsChecked(String url, String named) {
        assertThatThrownBy(() -> BrokerAddress.parse(url, Map.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(named);
    }
}
