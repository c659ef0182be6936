# permgen_effect(): to come
