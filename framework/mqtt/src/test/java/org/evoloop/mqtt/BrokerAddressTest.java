package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BrokerAddressTest {
    @TempDir
    private Path directory;

    @ParameterizedTest
    @CsvSource({
        "mqtt://broker, mqtt://broker:1883",
        "mqtts://broker, mqtts://broker:8883",
        "mqtt://ha@broker:1884/, mqtt://ha@broker:1884",
        "mqtt://[::1]:1883, mqtt://[::1]:1883",
        "mqtt://my_broker, mqtt://my_broker:1883",
        "mqtts://me%40home@my_broker:1884?id=hall, mqtts://me@home@my_broker:1884",
        "mqtts://192.168.1.2?id=hall&discovery=ha, mqtts://192.168.1.2:8883"
    })
    void whereTheBrokerIs(String url, String read) {
        assertThat(BrokerAddress.parse(url)).hasToString(read);
    }

    @Test
    void theIdIsTheConvertersNameUnlessTheAddressHasOne() {
        assertThat(BrokerAddress.parse("mqtt://b").id("my lamp")).isEqualTo("my_lamp");
        assertThat(BrokerAddress.parse("mqtt://b?id=hall").id("lamp")).isEqualTo("hall");
    }

    @Test
    void thePasswordComesFromTheEnvironmentOrAFile() throws Exception {
        Map<String, String> environment = Map.of("EVOLOOP_MQTT_PASSWORD", "s3cret");
        assertThat(address(environment, "--mqtt", "mqtt://ha@b").password()).isEqualTo("s3cret");
        assertThat(address(environment, "--mqtt", "mqtt://b").password()).isNull();
        Path file = Files.writeString(directory.resolve("password"), "other\n");
        assertThat(address(environment, "--mqtt", "mqtt://ha@b", "--mqtt-password-file", file.toString())
                        .password())
                .isEqualTo("other");
        assertThat(address(environment, "--mqtt", "mqtt://ha@b").toString()).doesNotContain("s3cret");
        assertThatThrownBy(() -> address(environment, "--mqtt", "mqtt://b", "--mqtt-password-file", file.toString()))
                .hasMessageContaining("mqtt://USER@HOST");
        assertThatThrownBy(() -> BrokerAddress.parse("mqtt://b").withPassword("s3cret"))
                .hasMessageContaining("mqtt://USER@HOST")
                .hasMessageNotContaining("s3cret");
    }

    private static BrokerAddress address(Map<String, String> environment, String... arguments) {
        return MqttOptions.broker(MqttOptions.OPTIONS.read(List.of(arguments), environment))
                .orElseThrow();
    }

    @Test
    void certificatesLieBesideTheFileThatNamesThem() throws Exception {
        Path file = Files.writeString(directory.resolve("lamp.yaml"), "mqtt: mqtts://b?ca=gone.pem&id=hall\n");
        assertThatThrownBy(() -> address(Map.of(), "--config", file.toString()))
                .hasMessageContaining(directory.resolve("gone.pem").toString());
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
                "mqtt://broker#x",
                "mqtt://my_broker:0",
                "mqtt://my_broker:99999"
            })
    void whatNamesNoBrokerIsRefusedWithAnExample(String url) {
        assertThatThrownBy(() -> BrokerAddress.parse(url))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(url)
                .hasMessageContaining("mqtt://HOST");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "mqtt://ha:s3cret@b",
                "mqtt://ha:s3cret@b ad",
                "mqtt://ha:s3@cret@b",
                "http://ha:s3cret@b",
                "mqtt://ha%3As3cret@b",
                "mqtt://ha:s3/cret@b",
                "mqtt://ha:s3?x=cret@b",
                "mqtt://ha@home:s3cret@b",
                "mqtt://ha:s3cret@my_broker",
                "mqtt://h/a:s3cret@b",
                "mqtt:/ha:s3cret@b",
                "mqtt:ha:s3cret@b",
                "ha:s3cret@b",
                "mqtt://b?user=ha&password=s3cret",
                "mqtt://b:99999?password=s3cret&id=x"
            })
    void aPasswordInTheUrlIsRefusedAndNotShown(String url) {
        assertThatThrownBy(() -> BrokerAddress.parse(url))
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
        "mqtts://b?sha256=12:34, 64 digits",
        "mqtt://b?sha256=0, mqtts://",
        "mqtts://b?sha256=0&ca=/x, both",
        "mqtt://ha@b?password-file=/x, 'password-file'"
    })
    void whatFollowsTheQuestionMarkIsChecked(String url, String named) {
        assertThatThrownBy(() -> BrokerAddress.parse(url))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(named);
    }
}
